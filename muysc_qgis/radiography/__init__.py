"""Muon spectra, energy loss, ray tracing, transmission and counting statistics."""
