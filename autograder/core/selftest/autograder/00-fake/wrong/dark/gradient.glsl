// Fails: Task1Gradient.RisesFromLeftToRight · the gradient is half as steep
behave dark
