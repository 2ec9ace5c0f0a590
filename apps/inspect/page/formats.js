// Texels as numbers, format by format (CONVENTIONS.md, "Number formats" and "Surfaces in memory").

function half(bits) {
    const exponent = bits >> 10 & 31, fraction = bits & 1023, sign = bits >> 15 ? -1 : 1;
    if (exponent === 31)
        return fraction ? NaN : sign * Infinity;
    return sign * (exponent ? 2 ** (exponent - 15) * (1 + fraction / 1024) : 2 ** -14 * (fraction / 1024));
}

const unorm = (code) => Math.fround(code / 255);
const bgra = (v, at) => [unorm(v.getUint8(at + 2)), unorm(v.getUint8(at + 1)), unorm(v.getUint8(at))];

/** For each format: names of its channels, and a texel's values from a DataView and a place; of those whose
 * channels are bytes also where each byte is. */
export const formats = {
    A8R8G8B8: { channels: "rgba", bytes: [2, 1, 0, 3], read: (v, at) => [...bgra(v, at), unorm(v.getUint8(at + 3))] },
    X8R8G8B8: { channels: "rgb", bytes: [2, 1, 0], read: bgra },
    R8: { channels: "r", bytes: [0], read: (v, at) => [unorm(v.getUint8(at))] },
    G16R16F: { channels: "rg", float: true, read: (v, at) => [0, 2].map((i) => half(v.getUint16(at + i, true))) },
    A16B16G16R16F: {
        channels: "rgba", float: true,
        read: (v, at) => [0, 2, 4, 6].map((i) => half(v.getUint16(at + i, true))),
    },
    R32F: { channels: "r", float: true, read: (v, at) => [v.getFloat32(at, true)] },
    A32B32G32R32F: {
        channels: "rgba", float: true,
        read: (v, at) => [0, 4, 8, 12].map((i) => v.getFloat32(at + i, true)),
    },
    D16: { channels: "d", depth: true, read: (v, at) => [Math.fround(v.getUint16(at, true) / 65535)] },
    D24S8: {
        channels: "ds", depth: true,
        read: (v, at) => [Math.fround((v.getUint32(at, true) >>> 8) / 16777215), v.getUint8(at)],
    },
    D32F: { channels: "d", depth: true, read: (v, at) => [v.getFloat32(at, true)] },
};

export const channel_names = { r: "red", g: "green", b: "blue", a: "alpha", d: "depth", s: "stencil" };
