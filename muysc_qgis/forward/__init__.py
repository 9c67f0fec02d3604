"""What a telescope counts behind rock, summed over the sub-rays of every trajectory."""
