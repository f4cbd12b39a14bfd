#!/usr/bin/python3
"""vtk_frame.py POT.glb WIDTH HEIGHT FRAMES: VTK's physically based shading of the pot, one light, plain background, read
back. Prints the milliseconds of each frame, one a line. Needs a display and Debian's python3-vtk9."""
import sys
import time

import vtk


def main():
    path, width, height, frames = sys.argv[1], *map(int, sys.argv[2:5])
    reader = vtk.vtkGLTFReader()
    reader.SetFileName(path)
    surface = vtk.vtkCompositeDataGeometryFilter()
    surface.SetInputConnection(reader.GetOutputPort())
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    pot = vtk.vtkActor()
    pot.SetMapper(mapper)
    pot.GetProperty().SetInterpolationToPBR()
    pot.GetProperty().SetColor(0.36, 0.29, 0.215)
    pot.GetProperty().SetRoughness(0.62)
    pot.GetProperty().SetMetallic(0.0)
    pot.GetProperty().BackfaceCullingOn()
    light = vtk.vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(-0.74, 0.6, 0.4)
    light.SetFocalPoint(0, 0, 0)
    renderer = vtk.vtkRenderer()
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(light)
    renderer.AddActor(pot)
    renderer.SetBackground(0.2, 0.18, 0.16)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0.285, 0.805)
    camera.SetFocalPoint(0, 0.082, 0)
    camera.SetViewAngle(26.99)
    renderer.ResetCameraClippingRange()
    pixels = vtk.vtkUnsignedCharArray()
    for frame in range(frames + 3):
        pot.RotateY(2.0)
        start = time.perf_counter()
        window.Render()
        window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
        if frame >= 3:
            print("%.3f" % (1000.0 * (time.perf_counter() - start)))
    covered = sum(1 for k in range(0, pixels.GetNumberOfTuples(), 97) if pixels.GetComponent(k, 0) not in (50, 51))
    if covered < 50:
        sys.exit("vtk_frame: expected a pot in the picture, found none")


main()
