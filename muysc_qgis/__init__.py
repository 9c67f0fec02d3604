"""Simulation of muon radiography and tomography of large structures."""

__version__ = "0.1.0"
