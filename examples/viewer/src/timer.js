// GPU time of each pass, where the browser has timer queries: they answer some frames later.
const KEEP = 0.8;

export class Timer {
    #pending = [];
    times = new Map();
    drawn = new Set();

    constructor(gl) {
        this.reset(gl);
    }

    reset(gl) {
        this.gl = gl;
        this.extension = gl.getExtension("EXT_disjoint_timer_query_webgl2");
        this.#pending = [];
    }

    get isThere() {
        return this.extension !== null;
    }

    // Names of passes that are no longer drawn are forgotten.
    begin() {
        this.drawn.clear();
        this.collect();
    }

    // Draws, and gives what that gives.
    measured(name, draw) {
        // Queries do not nest: a pass within another counts to that.
        if (!this.extension || this.isMeasuring || this.#pending.length > 60)
            return draw();
        this.drawn.add(name);
        this.isMeasuring = true;
        const query = this.gl.createQuery();
        this.gl.beginQuery(this.extension.TIME_ELAPSED_EXT, query);
        const result = draw();
        this.gl.endQuery(this.extension.TIME_ELAPSED_EXT);
        this.isMeasuring = false;
        this.#pending.push({name, query});
        return result;
    }

    collect() {
        if (!this.extension)
            return;
        const disjoint = this.gl.getParameter(this.extension.GPU_DISJOINT_EXT);
        this.#pending = this.#pending.filter(({name, query}) => {
            if (!this.gl.getQueryParameter(query, this.gl.QUERY_RESULT_AVAILABLE))
                return true;
            const milliseconds = this.gl.getQueryParameter(query, this.gl.QUERY_RESULT) / 1e6;
            this.gl.deleteQuery(query);
            if (!disjoint) {
                const before = this.times.get(name);
                this.times.set(name, before === undefined ? milliseconds : KEEP * before + (1 - KEEP) * milliseconds);
            }
            return false;
        });
    }

    // [name, milliseconds] of the passes of the last frame.
    rows() {
        return [...this.drawn].filter((name) => this.times.has(name)).map((name) => [name, this.times.get(name)]);
    }

    get isWaiting() {
        return this.#pending.length > 0;
    }
}
