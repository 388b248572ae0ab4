"""What regression/nddiff and regression/ndregress are made of."""
