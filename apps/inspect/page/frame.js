// The frame: passes, draws, stops, the fragments of every pixel and the histories of some.

import { blob, json } from "page/data.js";
import { Targets } from "page/targets.js";

// Fragments of a pass, unpacked (apps/inspect/fragments.h): where the run of each pixel begins.
class Fragments {
    constructor(pass, bytes) {
        this.bytes = bytes;
        this.width = pass.width;
        this.starts = new Uint32Array(pass.width * pass.height);
        for (let at = 0, pixel = 0; at < bytes.length;) {
            let [pixels, next] = this.number(at);
            this.starts.fill(next, pixel, pixel + pixels);
            pixel += pixels;
            let count;
            [count, next] = this.number(next);
            for (let i = 0; i < 3 * count; i++)
                next = this.number(next)[1];
            at = next;
        }
    }

    number(at) {
        let value = 0, shift = 0, byte;
        do {
            byte = this.bytes[at++];
            value += (byte & 127) * 2 ** shift;
            shift += 7;
        } while (byte & 128);
        return [value, at];
    }

    at(x, y) {
        let [count, next] = this.number(this.starts[y * this.width + x]);
        const list = [];
        for (let i = 0; i < count; i++) {
            const one = {};
            for (const member of ["draw", "primitive", "verdict"])
                [one[member], next] = this.number(next);
            one.front = one.verdict >= 16;
            one.verdict %= 16;
            list.push(one);
        }
        return list;
    }
}

export class Frame {
    constructor(data) {
        Object.assign(this, data);
        this.all_stops = [];
        for (const pass of this.passes) {
            pass.first_stop = this.all_stops.length;
            for (const stop of pass.stops) {
                stop.pass = pass.pass;
                this.all_stops.push(stop);
            }
            pass.pixel_numbers = new Map(pass.histories.pixels.map(([x, y], i) => [y * pass.width + x, i]));
        }
        this.targets = new Targets(this.surfaces, this.all_stops);
        this.unpacked = [];
    }

    static async load(number) {
        return new Frame(await json(number));
    }

    /** The stop of the whole frame after which a draw is on the targets. */
    stop_of(pass, draw) {
        const stops = this.passes[pass].stops;
        const at = stops.findIndex((stop) => draw < stop.first + stop.count);
        return this.passes[pass].first_stop + (at < 0 ? stops.length - 1 : at);
    }

    async fragments(pass) {
        this.unpacked[pass] ??= blob(this.passes[pass].fragments).then(
            (bytes) => new Fragments(this.passes[pass], bytes));
        return this.unpacked[pass];
    }

    /** Levels of detail of a pass (fragments.h), or null. */
    lod(pass) {
        return this.passes[pass].lod >= 0 ? blob(this.passes[pass].lod) : null;
    }

    /** How far the picture is above the exact one at each pixel, or below (inspect.h); null: unknown. */
    async off() {
        if (this.truth)
            this.unpacked_off ??= blob(this.truth.off).then((bytes) => new Float32Array(bytes.buffer));
        return this.unpacked_off ?? null;
    }

    /** Whether a pass draws the picture. */
    has_picture(pass) {
        return this.passes[pass].targets.some((target) => target.surface === this.picture);
    }

    /** Whether all values of a pixel are in the page. */
    is_recorded(pass, x, y) {
        return this.passes[pass].pixel_numbers.has(y * this.passes[pass].width + x);
    }

    /** The recorded pixel that is nearest. */
    nearest(pass, x, y) {
        let best = null, least = Infinity;
        for (const [px, py] of this.passes[pass].histories.pixels) {
            const distance = (px - x) ** 2 + (py - y) ** 2;
            if (distance < least) {
                least = distance;
                best = [px, py];
            }
        }
        return best;
    }

    /** All events of a recorded pixel; null: it is not. */
    async history(pass, x, y) {
        const number = this.passes[pass].pixel_numbers.get(y * this.passes[pass].width + x);
        if (number === undefined)
            return null;
        const each = 32, chunk = await json(this.passes[pass].histories.blobs[Math.floor(number / each)]);
        return chunk[number % each].events;
    }

    /** Vertices, clipping and set-up of a primitive; null: they are not recorded. */
    async primitive(pass, draw, primitive) {
        const { primitives, primitive_blobs } = this.passes[pass].histories;
        const number = primitives[`${draw}/${primitive}`];
        if (number === undefined)
            return null;
        return (await json(primitive_blobs[Math.floor(number / 32)]))[number % 32];
    }

    draw_of(pass, draw) {
        return this.passes[pass].draws[draw];
    }
}

/** Events of a pixel by fragment: { draw, primitive, raster, interpolate, textures, pixel, steps, sort,
 * tests, outputs, missed }, in the order in which they began. */
export function by_fragment(events) {
    const fragments = [];
    for (const event of events) {
        const begins = event.kind === "raster" || event.kind === "missed";
        let one = fragments.findLast((f) => f.draw === event.draw && f.primitive === event.primitive);
        if (begins || !one) {
            one = { draw: event.draw, primitive: event.primitive, textures: [], tests: [], outputs: [] };
            fragments.push(one);
        }
        if (event.kind === "texture")
            one.textures.push(event);
        else if (event.kind === "test")
            one.tests.push(event);
        else if (event.kind === "output")
            one.outputs.push(event);
        else
            one[event.kind] = event;
    }
    return fragments;
}
