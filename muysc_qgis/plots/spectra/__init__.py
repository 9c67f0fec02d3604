"""Figures and report that compare muon spectra, energy losses and fluxes behind rock."""
