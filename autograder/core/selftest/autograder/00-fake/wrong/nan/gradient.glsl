// Fails: Task1Gradient.RisesFromLeftToRight, Task1Gradient.NeverBrighterThanOne · a division by zero
behave nan
