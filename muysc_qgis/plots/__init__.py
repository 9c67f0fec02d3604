"""Figures and the report, drawn with matplotlib without a display."""
