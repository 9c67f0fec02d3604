"""Parameters that several algorithms share: how they are declared and read."""
