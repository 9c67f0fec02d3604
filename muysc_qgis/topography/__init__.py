"""Terrain: DEM windows, the local frame of a detector, profiles along rays."""
