#!/usr/bin/env python3
"""How work grows with ranks: measured here on 1, 2 and 4, and a model of what more would do.

    mpi_scale.py PROGRAM MPI_PROGRAM CHART.svg      measures, simulates, prints a table, draws a chart

Items are small scenes, drawn by ranks of one thread. From these runs come the times of items and what a
result costs rank 0 (messages, the journal, taking). The model is a list scheduler on these figures: rank 0
gives the longest item left to whoever is free, and one ahead; results wait where rank 0 is busy with
others; ranks are told to begin along a tree. Ranks that share this machine's processors show overhead, not
speed; times begin after mpirun's start. Measured and model are marked apart. On a machine where others are at
work, ranks, which are processes, may get a greater share than threads of one process: measure when it is quiet.
"""
import heapq, json, math, os, random, re, shutil, subprocess, sys, tempfile

NAMES = ['toon', 'near_clip', 'point_sprites', 'sorted', 'stencil_outline', 'two_sided_stencil', 'alpha_blend',
         'scissor']
COUNT = 200
TURNS = 7          # of which the quickest counts: others are at work on a machine


def make_folder(folder):
    os.makedirs(folder)
    for i in range(COUNT):
        shutil.copy(f'scenes/{NAMES[i % len(NAMES)]}.json', f'{folder}/s{i}.json')
    shutil.copytree('scenes/models', f'{folder}/models')


def run(words):
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT='1', OMPI_ALLOW_RUN_AS_ROOT_CONFIRM='1',
                       GLASSPIPE_MPI_COUNTS='1')
    done = subprocess.run(words, capture_output=True, text=True, env=environment)
    assert done.returncode in (0, 1), done.stderr
    return done


def measure(program, ranked, folder):
    """Item times in s; per K: (wall s, messages and bytes an item, rank 0's ms an item); threads: wall s."""
    task = ['test', folder, '--size', '256x256', '--json']
    items, walls, threads = [], {}, {}
    for _ in range(TURNS):
        for count in (1, 2):
            done = run([program, *task, '--threads', str(count)])
            result = json.loads(done.stdout)
            threads.setdefault(count, []).append(result['seconds'])
            if count == 1:
                own = [one['seconds'] for one in result['results']]
                items = [min(pair) for pair in zip(items, own)] if items else own
        for ranks in (2, 4):
            start = ['mpirun', '-q', '--oversubscribe', '-n', str(ranks), ranked]
            done = run([*start, *task, '--threads', '1'])
            found = re.search(r'items on \d+ ranks: ([\d.]+) s; rank 0: (\d+) messages, (\d+) bytes, ([\d.]+) ms',
                              done.stderr)
            wall, messages, size, busy = map(float, found.groups())
            walls.setdefault(ranks, []).append((wall, messages / COUNT, size / COUNT, busy / COUNT))
    least = lambda rows: tuple(min(column) for column in zip(*rows))
    return items, {k: least(v) for k, v in walls.items()}, {k: min(v) for k, v in threads.items()}


def simulate(items, ranks, service, hop, group=1):
    """Wall time of items (s each) on ranks; service: s of rank 0 for a message's result; group: items a
    message. One rank draws alone; of more, rank 0 only hands out and takes here: of 1,000 it is one."""
    if ranks == 1:
        return sum(items)
    order = sorted(items, reverse=True)
    batches = [sum(order[i:i + group]) for i in range(0, len(order), group)]
    start = hop * math.ceil(math.log2(ranks))
    free = [(start, rank) for rank in range(ranks - 1)]       # when a rank needs its next batch
    heapq.heapify(free)
    server = start
    end = start
    results = []                                              # when results come to rank 0
    for batch in batches:
        at, rank = heapq.heappop(free)
        begin = max(at, 0)
        done = begin + batch
        heapq.heappush(free, (done, rank))
        results.append(done + hop)
    # rank 0 takes results in the order in which they come, one after the other; with one batch ahead a rank
    # waits for rank 0 only where that is more than a batch behind, which bounds the whole from below
    for done in sorted(results):
        server = max(server, done) + service
        end = max(end, server)
    return end


def draw(path, curves, points):
    width, height, left, top, right, bottom = 720, 420, 64, 40, 20, 52
    x = lambda ranks: left + (width - left - right) * math.log10(ranks) / 3
    y = lambda speed: height - bottom - (height - top - bottom) * math.log10(max(speed, 1)) / 3
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
           f'font-size="13"><rect width="{width}" height="{height}" fill="#fff"/>',
           f'<text x="{left}" y="22" font-size="15">Times as fast as one rank: model (lines) and measured (dots)'
           '</text>']
    for power in range(4):
        at, value = 10 ** power, f'{10 ** power:,}'
        out.append(f'<path d="M{x(at):.1f} {top}V{height - bottom}M{left} {y(at):.1f}H{width - right}" '
                   'stroke="#ddd"/>')
        out.append(f'<text x="{x(at):.1f}" y="{height - bottom + 18}" text-anchor="middle">{value}</text>')
        out.append(f'<text x="{left - 8}" y="{y(at) + 4:.1f}" text-anchor="end">{value}</text>')
    out.append(f'<text x="{(left + width - right) / 2}" y="{height - 12}" text-anchor="middle">ranks</text>')
    colors = ['#1b6ca8', '#c05a1e', '#3c8d40']
    for number, (name, curve) in enumerate(curves):
        d = 'M' + 'L'.join(f'{x(k):.1f} {y(s):.1f}' for k, s in curve)
        out.append(f'<path d="{d}" fill="none" stroke="{colors[number]}" stroke-width="2" '
                   f'stroke-dasharray="{["none", "6 4", "2 3"][number]}"/>')
        out.append(f'<text x="{left + 14}" y="{top + 18 + 18 * number}" fill="{colors[number]}">model: {name}'
                   '</text>')
    for ranks, speed in points:
        out.append(f'<circle cx="{x(ranks):.1f}" cy="{y(speed):.1f}" r="4.5" fill="none" stroke="#000" '
                   'stroke-width="2"/>')
    out.append(f'<text x="{left + 14}" y="{top + 18 + 18 * len(curves)}">o measured: 2 and 4 ranks on two '
               'processors</text>')
    out.append('</svg>')
    with open(path, 'w') as file:
        file.write('\n'.join(out) + '\n')


def main():
    program, ranked, chart = sys.argv[1:4]
    folder = tempfile.mkdtemp() + '/golden'
    os.chdir(os.path.dirname(os.path.abspath(__file__)) + '/../..')
    make_folder(folder)
    items, walls, threads = measure(os.path.abspath(program), os.path.abspath(ranked), folder)
    shutil.rmtree(os.path.dirname(folder))
    typical = sorted(items)[len(items) // 2]
    service = walls[2][3] / 1e3
    hop = 50e-6                                               # between machines: a cluster's, taken large
    print(f'{COUNT} scenes of 256x256, ms: median {typical * 1e3:.2f}, most {max(items) * 1e3:.2f}')
    print(f'one process: 1 thread {threads[1]:.3f} s, 2 threads {threads[2]:.3f} s')
    for ranks, (wall, messages, size, busy) in walls.items():
        print(f'{ranks} ranks of one thread: {wall:.3f} s = {threads[2] / wall:.3f} times as fast as 2 threads; '
              f'{messages:.2f} messages and {size:.0f} bytes an item, rank 0 {busy * 1e3:.1f} us an item = '
              f'{busy / typical / 10:.2f} % of the median')
    randomizer = random.Random(1)
    many = [randomizer.choice(items) for _ in range(50000)]
    ranks = [1, 2, 4, 10, 20, 50, 100, 200, 500, 1000]
    alone = sum(many)
    curves = []
    for name, group in (('50,000 such scenes', 1), ('the same, 8 items a message', 8)):
        curve = [(k, alone / simulate(many, k, service * (1 if group == 1 else 1 + 0.2 * group), hop, group))
                 for k in ranks]
        curves.append((name, curve))
    long = [one * 20 for one in many[:20000]]
    curves.append(('20,000 items of 20 times that', [(k, sum(long) / simulate(long, k, service, hop))
                                                     for k in ranks]))
    for name, curve in curves:
        print(f'model, {name}: ' + ', '.join(f'{k} ranks {s:.1f}' for k, s in curve if k in (10, 100, 1000)))
    saturation = typical / service
    print(f'rank 0 is full from {saturation:.0f} ranks on (median item / its own time an item)')
    draw(chart, curves, [(1, 1)] + [(k, threads[1] / wall[0]) for k, wall in walls.items()])


main()
