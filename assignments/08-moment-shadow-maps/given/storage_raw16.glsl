// Each moment by itself, moved from [-1,1] into [0,1].
vec4 storedMoments(vec4 moments) { return 0.5 * moments + 0.5; }

vec4 momentsFromStored(vec4 stored) { return 2.0 * stored - 1.0; }
