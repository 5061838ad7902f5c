"""Tools of the house: they make and measure the product and are no part of it."""
