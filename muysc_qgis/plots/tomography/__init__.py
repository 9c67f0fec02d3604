"""Figures of reconstructions, and their reports."""
