// What receivers.frag left of the surface in each pixel. Twin: ReceiverImages in render/deferred.h.
uniform sampler2D receiverPosition;     // u, v, depth: [0,1]³ inside the map; w: 1 a surface before the light, 0 one in the dark, -1 none
uniform sampler2D receiverLightHeight;  // of the light's point (s, t) over the receiver's plane: x + s y + t z, s, t in [-1/2, 1/2]
uniform sampler2D unlitColor;           // ambient and emitted light
uniform sampler2D directColor;          // the light's own, before any shadow
