"""Telescopes of pixel planes: geometry, acceptance, directions, counting statistics."""
