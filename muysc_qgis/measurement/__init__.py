"""What was measured: reading it from text, counting errors, and the density that explains it."""
