vec4 storedMoments(vec4 moments) { return moments; }

vec4 momentsFromStored(vec4 stored) { return stored; }
