"""What the plugin does from start to end: terrain, muons, telescopes and files put together."""
