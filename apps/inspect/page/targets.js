// What the targets held after each stop of the frame (apps/inspect/targets.h has the form).

import { blob } from "page/data.js";
import { formats } from "page/formats.js";

/** One surface at one moment. */
export class Image {
    constructor(surface, bytes, ranges) {
        this.surface = surface;
        this.ranges = ranges;
        this.bytes = bytes;
        this.view = new DataView(bytes.buffer);
        this.format = formats[surface.format];
    }

    /** Values of a texel's channels. */
    at(x, y) {
        return this.format.read(this.view, (y * this.surface.width + x) * this.surface.bytes);
    }

    /** Least, largest and histogram of a channel, and how many are no finite numbers: as recorded. */
    range(channel) {
        return this.ranges[channel];
    }
}

/** All surfaces at all stops. stops: of the whole frame in order, [{ targets: [{ surface, blob }] }]. */
export class Targets {
    constructor(surfaces, stops) {
        this.surfaces = surfaces;
        this.changes = surfaces.map(() => []);
        stops.forEach((stop, i) => {
            for (const { surface, blob: number, ranges } of stop.targets)
                this.changes[surface].push({ stop: i, blob: number, ranges });
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
            known[changes] = new Image(surface, bytes, changes ? this.changes[number][changes - 1].ranges : surface.ranges);
        }
        return known[changes];
    }

    /** A surface after a stop; stop -1: before the frame. */
    after(number, stop) {
        const changes = this.changes[number].filter((change) => change.stop <= stop).length;
        return this.state(number, changes);
    }
}
