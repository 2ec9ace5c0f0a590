#!/usr/bin/env python3
"""Whole commands against the clock, from a mesh's file to a picture's, beside what else does it.

    bench_commands.py PROGRAM MESH...      prints a table of ms, medians of ROUNDS (7) runs

Ours is one command in parts, told apart by commands that leave some out: `start` (--version), `load` (a picture
of one pixel: reading, normals, tables), `draw` (a PPM of 1024 x 1024, which is not compressed), `write` (the
PNG). Beside it VTK from Python, by the system's driver without a window (Xvfb), timed inside by the same parts;
and the comparison of two such pictures by ImageMagick. What is not installed is said to be skipped.
"""
import json, os, shutil, statistics, subprocess, sys, tempfile, time

ROUNDS = int(os.environ.get('ROUNDS', 7))
VTK = '''
import sys, time
t = [time.time()]
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)
import vtkmodules.vtkRenderingOpenGL2
t.append(time.time())
reader, normals, writer = vtkPLYReader(), vtkPolyDataNormals(), vtkPNGWriter()
reader.SetFileName(sys.argv[1])
normals.SplittingOff()
normals.SetInputConnection(reader.GetOutputPort())
normals.Update()
t.append(time.time())
mapper, actor, renderer, window = vtkPolyDataMapper(), vtkActor(), vtkRenderer(), vtkRenderWindow()
mapper.SetInputConnection(normals.GetOutputPort())
actor.SetMapper(mapper)
renderer.AddActor(actor)
window.SetOffScreenRendering(1)
window.SetSize(1024, 1024)
window.AddRenderer(renderer)
window.Render()
image = vtkWindowToImageFilter()
image.SetInput(window)
image.Update()
t.append(time.time())
writer.SetFileName(sys.argv[2])
writer.SetInputConnection(image.GetOutputPort())
writer.Write()
t.append(time.time())
print(*(1e3 * (b - a) for a, b in zip(t, t[1:])))
'''


def wall(words):
    begun = time.time()
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return 1e3 * (time.time() - begun), done.stdout


def median(words):
    return statistics.median(wall(words)[0] for _ in range(ROUNDS))


def row(what, parts):
    print(f'{what:34}' + ''.join(f'{part:9.1f}' for part in parts) + f'{sum(parts):9.1f}')


def ours(program, mesh, folder):
    scene = os.path.join(folder, 'scene.json')
    with open(scene, 'w') as file:
        json.dump({'size': [1024, 1024],
                   'camera': {'eye': [0, 0.6, 3], 'at': [0, 0.5, 0], 'fovy': 26, 'near': 0.5, 'far': 20},
                   'lights': [{'direction': [-0.4, 0.7, 0.7]}],
                   'objects': [{'mesh': os.path.abspath(mesh), 'fit': [0, 0, 0, 1]}]}, file)
    render = [program, 'render', scene, '-q', '-o']
    times = [median([program, '--version']), median(render + [f'{folder}/small.ppm', '--size', '1x1']),
             median(render + [f'{folder}/picture.ppm']), median(render + [f'{folder}/picture.png'])]
    row(f'glasspipe {os.path.basename(mesh)}', [times[0]] + [max(0, b - a) for a, b in zip(times, times[1:])])


def vtk(mesh, folder):
    runs = []
    for _ in range(ROUNDS):
        whole, printed = wall([shutil.which('python3', path='/usr/bin') or sys.executable, '-c', VTK, mesh,
                               f'{folder}/vtk.png'])
        parts = [float(word) for word in printed.split()[-4:]]
        runs.append([whole - sum(parts[1:])] + parts[1:])   # the interpreter's own start too
    row(f'VTK {os.path.basename(mesh)}', [statistics.median(run[i] for run in runs) for i in range(4)])


def compare(program, folder):
    shutil.copy(f'{folder}/picture.png', f'{folder}/other.png')
    pair = [f'{folder}/picture.png', f'{folder}/other.png']
    print(f'{"glasspipe compare":34}{median([program, "compare", *pair]):45.1f}')
    if shutil.which('compare'):
        print(f'{"ImageMagick compare":34}{median(["compare", "-metric", "AE", *pair, "null:"]):45.1f}')
    else:
        print('ImageMagick compare: skipped, it is not installed')


def has_vtk():
    return subprocess.run(['/usr/bin/python3', '-c', 'import vtkmodules'], capture_output=True).returncode == 0


def main():
    program, meshes = sys.argv[1], sys.argv[2:]
    print(f'{"ms, 1024 x 1024":34}' + ''.join(f'{word:>9}' for word in ('start', 'load', 'draw', 'write', 'whole')))
    display = None
    if has_vtk() and shutil.which('Xvfb'):
        os.environ['DISPLAY'] = ':97'
        display = subprocess.Popen(['Xvfb', ':97', '-screen', '0', '1024x1024x24'], stderr=subprocess.DEVNULL)
        time.sleep(2)
    with tempfile.TemporaryDirectory() as folder:
        for mesh in meshes:
            ours(program, mesh, folder)
            if display and mesh.endswith('.ply'):
                vtk(mesh, folder)
        if not display:
            print('VTK: skipped, python3-vtk9 or Xvfb is not installed')
        compare(program, folder)
    if display:
        display.terminate()


main()
