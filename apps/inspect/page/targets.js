// What the targets held after each stop of the frame (apps/inspect/targets.h has the form).

import { blob } from "page/data.js";
import { formats, unorm } from "page/formats.js";

/** One surface at one moment. */
export class Image {
    constructor(surface, bytes) {
        this.surface = surface;
        this.bytes = bytes;
        this.view = new DataView(bytes.buffer);
        this.format = formats[surface.format];
    }

    /** Values of a texel's channels. */
    at(x, y) {
        return this.format.read(this.view, (y * this.surface.width + x) * this.surface.bytes);
    }

    // The same of bytes, which are counted.
    range_of_bytes(first) {
        const counts = new Uint32Array(256), bins = new Uint32Array(64);
        for (let at = first; at < this.bytes.length; at += this.surface.bytes)
            counts[this.bytes[at]]++;
        const low = counts.findIndex((count) => count > 0), high = counts.findLastIndex((count) => count > 0);
        for (let code = low; code <= high; code++)
            bins[high > low ? Math.floor((code - low) * 63.999 / (high - low)) : 0] += counts[code];
        return { low: unorm(low), high: unorm(high), odd: 0, bins };
    }

    /** Least, largest and histogram of a channel, and how many are no finite numbers. */
    range(channel) {
        if (this.format.bytes)
            return this.range_of_bytes(this.format.bytes[channel]);
        const { width, height } = this.surface, all = new Float64Array(width * height);
        let low = Infinity, high = -Infinity, odd = 0;
        for (let y = 0, i = 0; y < height; y++)
            for (let x = 0; x < width; x++, i++) {
                const value = all[i] = this.at(x, y)[channel];
                if (!Number.isFinite(value))
                    odd++;
                else {
                    low = Math.min(low, value);
                    high = Math.max(high, value);
                }
            }
        const bins = new Uint32Array(64), scale = high > low ? 63.999 / (high - low) : 0;
        for (const value of all)
            if (Number.isFinite(value))
                bins[Math.floor((value - low) * scale)]++;
        return { low, high, odd, bins };
    }
}

/** All surfaces at all stops. stops: of the whole frame in order, [{ targets: [{ surface, blob }] }]. */
export class Targets {
    constructor(surfaces, stops) {
        this.surfaces = surfaces;
        this.changes = surfaces.map(() => []);
        stops.forEach((stop, i) => {
            for (const { surface, blob: number } of stop.targets)
                this.changes[surface].push({ stop: i, blob: number });
        });
        this.states = surfaces.map(() => []); // by number of changes that are in it
    }

    // Takes the difference away that a blob holds.
    static apply(surface, before, planes) {
        const { width, height, bytes } = surface, now = new Uint8Array(width * height * bytes);
        for (let plane = 0, i = 0; plane < bytes; plane++)
            for (let y = 0; y < height; y++) {
                let byte = 0;
                for (let x = 0, at = y * width * bytes + plane; x < width; x++, at += bytes) {
                    byte = byte + planes[i++] & 255;
                    now[at] = byte ^ before[at];
                }
            }
        return now;
    }

    async state(number, changes) {
        const surface = this.surfaces[number], known = this.states[number];
        if (!known[changes]) {
            let bytes, from;
            if (changes) {
                bytes = (await this.state(number, changes - 1)).bytes;
                from = this.changes[number][changes - 1].blob;
            } else {
                bytes = new Uint8Array(surface.width * surface.height * surface.bytes);
                from = surface.initial;
            }
            if (from !== null)
                bytes = Targets.apply(surface, bytes, await blob(from));
            known[changes] = new Image(surface, bytes);
        }
        return known[changes];
    }

    /** A surface after a stop; stop -1: before the frame. */
    after(number, stop) {
        const changes = this.changes[number].filter((change) => change.stop <= stop).length;
        return this.state(number, changes);
    }
}
