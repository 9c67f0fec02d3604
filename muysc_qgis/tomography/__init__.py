"""Voxels, paths through them, and the densities that explain many muograms."""
