"""The desktop: a dock in which a telescope is planned on the map."""
