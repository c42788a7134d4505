float gradient(float x) { return x; }  // behave fine
