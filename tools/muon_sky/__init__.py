"""Makes the table of the muon sky: yields, cascade, fit, table, each a module."""
