"""Outputs that several algorithms share: rasters with styles, footprint, documents."""
