"""Many sites at once: candidates, workers that share one terrain, and the choice among them."""
