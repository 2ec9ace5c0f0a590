// A target as a picture: what is painted of its values.

/** Ways to look at a surface: [key, words]. */
export function ways(image) {
    const { channels, depth } = image.format;
    if (depth)
        return channels.includes("s") ? [["d", "depth"], ["s", "stencil"]] : [["d", "depth"]];
    const names = { r: "red", g: "green", b: "blue", a: "alpha" };
    return [["", "colour"], ...[...channels].map((c) => [c, names[c]])];
}

// Purple and yellow stripes, to be told from any value by their form too.
function odd(pixels, at, x, y) {
    const stripe = (x + y & 4) !== 0;
    pixels.set(stripe ? [255, 220, 0, 255] : [120, 0, 140, 255], at);
}

const byte = (value) => 255 * (value < 0 ? 0 : value > 1 ? 1 : value) + 0.5;

// Bytes in colour are pixels as they are.
function copy_bytes(pixels, image, [red, green, blue]) {
    const { bytes, surface } = image;
    for (let at = 0, from = 0; at < pixels.length; at += 4, from += surface.bytes) {
        pixels[at] = bytes[from + red];
        pixels[at + 1] = bytes[from + (green ?? red)];
        pixels[at + 2] = bytes[from + (blue ?? red)];
        pixels[at + 3] = 255;
    }
}

/** Paints a surface. way: "" in colour, or a channel, stretched over its range; NaN and infinite values
 * are striped. */
export function paint(canvas, image, way) {
    const { width, height } = image.surface;
    canvas.width = width;
    canvas.height = height;
    const data = new ImageData(width, height), pixels = data.data;
    if (!way && image.format.bytes) {
        copy_bytes(pixels, image, image.format.bytes);
        canvas.getContext("2d").putImageData(data, 0, 0);
        return null;
    }
    const channel = way ? image.format.channels.indexOf(way) : -1;
    const range = channel >= 0 ? image.range(channel) : null;
    const scale = range && range.high > range.low ? 1 / (range.high - range.low) : 0;
    for (let y = 0, at = 0; y < height; y++)
        for (let x = 0; x < width; x++, at += 4) {
            const v = image.at(x, y);
            if (channel >= 0 ? !Number.isFinite(v[channel]) : v.some((one) => !Number.isFinite(one))) {
                odd(pixels, at, x, y);
                continue;
            }
            pixels[at + 3] = 255;
            if (channel >= 0)
                pixels[at] = pixels[at + 1] = pixels[at + 2] =
                    byte(scale ? (v[channel] - range.low) * scale : v[channel]);
            else {
                pixels[at] = byte(v[0]);
                pixels[at + 1] = byte(v[1] ?? v[0]);
                pixels[at + 2] = byte(v[2] ?? (v.length === 1 ? v[0] : 0));
            }
        }
    canvas.getContext("2d").putImageData(data, 0, 0);
    return range;
}
