"""Physical constants and unit conversions, each with its unit and source."""

#: Muon mass in GeV (Particle Data Group, Phys. Rev. D 110, 030001, 2024).
MUON_MASS_GEV = 0.1056583755

#: Seconds in a day; spectra count per second, muograms per day.
SECONDS_PER_DAY = 86400.0

#: Momentum in GeV/c from which the open sky counts when no detection threshold is given.
OPEN_SKY_MOMENTUM_GEV = 1.0

#: Grams per square centimetre in one metre of water equivalent.
G_CM2_PER_M_WATER_EQUIVALENT = 100.0
