// The shaders of the backdrop layer: one triangle pair over the picture, a ray for each pixel.
//
// VTK's own uniform VCDCMatrix is the lens. A pixel at (x, y) of the picture, -1 .. 1, looks along
// (x / P00, y / P11, -1) in the frame of the camera; without perspective its ray starts at
// (x / P00, y / P11, 0) instead and all look along (0, 0, -1). In the world the ray is that times
// the axes of the camera. It meets the ground, h below the eye, where its direction d points down,
// after s = -h / d.y; the pixels at which d.y is 0 are the horizon.
//
// Sky and ground both become the colour of the haze there, by how steeply the ray runs and not by
// how far it goes: so they meet without an edge at any height of the eye. The pattern is filtered
// by the width of a pixel on the ground, so that it neither flickers nor sparkles.
#pragma once

namespace ripstop {

inline constexpr auto backdropVertexShader = R"(//VTK::System::Dec
in vec4 vertexMC;
out vec2 place;
void main()
{
    place = vertexMC.xy;
    gl_Position = vec4(vertexMC.xy, 1.0, 1.0);
}
)";

inline constexpr auto backdropFragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
//VTK::CustomUniforms::Dec
uniform mat4 MCDCMatrix;
in vec2 place;

const vec3 toSun = vec3(TO_SUN);
const float hazeOfSky = 7.5;     // 1 / slope, in powers of two
const float hazeOfGround = 26.0; // the same
const float farthest = 0.9999995; // what is as far as depth reaches is not drawn
const float behind = 16.0 / 65000.0; // of depth, as far as faces on which cloth may lie

// Lines at multiples of a side, m, and every other square between them. Both fade where squares are
// narrower than a few pixels. x: how much of the pixel lines cover; y: -1 or 1 by the square.
vec2 patternOf(vec2 q, vec2 pixel, vec2 perPixel, float side, float perSide)
{
    vec2 w = pixel * perSide; // sides per pixel
    // from the nearest line, in half sides; its sign is that of the square
    vec2 aside = abs(fract(0.5 * perSide * q + 0.25) - 0.5) - 0.25;
    vec2 pixels = 2.0 * side * aside * perPixel;
    vec2 seen = clamp(1.1 - 5.0 * w, 0.0, 1.0);
    vec2 line = clamp(0.5 * lineWidth + 0.5 - abs(pixels), 0.0, 1.0) * seen;
    vec2 square = clamp(pixels, -0.5, 0.5) * seen;
    return vec2(max(line.x, line.y), 4.0 * square.x * square.y);
}

vec3 skyAt(vec3 d, float slope)
{
    vec3 sky = mix(skyColor, hazeColor, exp2(-hazeOfSky * max(slope, 0.0)));
    float glow = max(dot(d, toSun), 0.0);
    glow *= glow;
    glow *= glow;
    return mix(sky, sunColor, 0.45 * glow * glow);
}

vec3 groundAt(vec2 q, vec2 pixel)
{
    vec2 perPixel = 1.0 / pixel;
    float side = groundStep.x, perSide = groundStep.z;
    float coarse = groundStep.y; // of the way to the next step
    vec2 narrow = patternOf(q, pixel, perPixel, side, perSide);
    vec2 wide = patternOf(q, pixel, perPixel, 10.0 * side, 0.1 * perSide);
    vec3 color = mix(groundColor, squareColor, 0.5 + 0.5 * mix(narrow.y, wide.y, coarse));
    return mix(color, lineColor, max(0.55 * (1.0 - coarse) * narrow.x, 0.6 * wide.x));
}

void main()
{
    bool parallel = isParallel > 0.5;
    vec2 lens = vec2(length(vec3(MCDCMatrix[0][0], MCDCMatrix[1][0], MCDCMatrix[2][0])),
                     length(vec3(MCDCMatrix[0][1], MCDCMatrix[1][1], MCDCMatrix[2][1])));
    vec2 across = place / lens;
    vec3 from = parallel ? vec3(across, 0.0) : vec3(0.0);
    vec3 along = parallel ? vec3(0.0, 0.0, -1.0) : vec3(across, -1.0);
    vec3 d = normalize(axisX * along.x + axisY * along.y + axisZ * along.z);
    vec3 start = axisX * from.x + axisY * from.y + axisZ * from.z;
    float height = eyeHeight + start.y;
    // without perspective there is no horizon, and the sky begins where the ground is seen on edge
    float slope = parallel ? d.y + 0.3 * height * lens.y : d.y;

    bool meets = height > 0.0 && d.y < -1.0e-6;
    float far = meets ? -height / d.y : 0.0; // m, along d
    vec2 q = eyePlace + start.xz + far * d.xz;
    bool onGround = meets && groundIsSolid > 0.5;
    vec2 pixel = max(fwidth(q), vec2(1.0e-7));

    float depth = far / length(along); // m in front of the eye
    float share = (depth - clip.x) / (clip.y - clip.x);
    gl_FragDepth = onGround ? clamp((parallel ? share : share * clip.y / depth) + behind, 0.0, farthest)
                            : farthest;

    vec3 color = paper;
    if (paper.x < 0.0) {
        bool under = d.y < 0.0 && (meets || !parallel);
        // beyond the edge of a landscape there is nothing but haze
        float thin = groundIsSolid > 0.5 ? hazeOfGround : 0.2 * hazeOfGround;
        float haze = parallel ? 0.0 : exp2(-thin * abs(d.y));
        if (onGround)
            color = mix(groundAt(q, pixel), hazeColor, haze);
        else if (under || slope < 0.0)
            color = mix(groundColor, hazeColor, haze);
        else
            color = skyAt(d, slope);
    }
    gl_FragData[0] = vec4(color, 1.0); // VTK finds its outputs by this name
}
)";

} // namespace ripstop
