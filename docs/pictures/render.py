#!/usr/bin/python3
"""Draws an Exodus file of a plane scene: deformed bodies coloured by a stress, element edges, undeformed outline.

    ndframe -i decks/punch.xml
    xvfb-run -a /usr/bin/python3 docs/pictures/render.py punch.e docs/pictures/punch.png stress_yy 0.15

Needs the Debian packages python3-vtk9 and xvfb; the product itself does not.
"""
import sys

import vtk


def read(path):
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.ApplyDisplacementsOff()  # it would move the nodes before we do
    reader.SetAllArrayStatus(vtk.vtkExodusIIReader.NODAL, 1)
    reader.SetAllArrayStatus(vtk.vtkExodusIIReader.ELEM_BLOCK, 1)
    reader.SetTimeStep(reader.GetNumberOfTimeSteps() - 1)
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    append = vtk.vtkAppendFilter()
    for i in range(blocks.GetNumberOfBlocks()):
        append.AddInputData(blocks.GetBlock(i))
    append.Update()
    return append.GetOutput()


def actor(algorithm, configure):
    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputConnection(algorithm.GetOutputPort())
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    configure(mapper, result)
    return result


def warped(grid, factor):
    """Moved by the displacement and, where a Gap stands between bodies, by the offset that draws them apart."""
    calculator = vtk.vtkArrayCalculator()
    calculator.SetInputData(grid)
    names = [grid.GetPointData().GetArrayName(i) for i in range(grid.GetPointData().GetNumberOfArrays())]
    terms = []
    for vector in ("disp_", "offset_"):
        if vector in names:
            calculator.AddVectorArrayName(vector)
            terms.append(vector)
        elif f"{vector}x" in names:
            calculator.AddScalarArrayName(f"{vector}x")
            calculator.AddScalarArrayName(f"{vector}y")
            terms.append(f"{vector}x*iHat + {vector}y*jHat")
    calculator.SetFunction(" + ".join(terms))
    calculator.SetResultArrayName("displacement")
    warp = vtk.vtkWarpVector()
    warp.SetInputConnection(calculator.GetOutputPort())
    warp.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "displacement")
    warp.SetScaleFactor(factor)
    return warp


def edges(source):
    """Straight element edges: the middle nodes are left out."""
    extract = vtk.vtkDataSetSurfaceFilter()
    extract.SetInputConnection(source.GetOutputPort())
    extract.SetNonlinearSubdivisionLevel(0)
    lines = vtk.vtkExtractEdges()
    lines.SetInputConnection(extract.GetOutputPort())
    return lines


def deformed_bounds(source):
    source.Update()
    return source.GetOutput().GetBounds()[:4]


def main(path, picture, variable, factor, low=None, high=None):
    grid = read(path)
    array = grid.GetCellData().GetArray(variable)
    bounds = array.GetRange() if low is None else (float(low), float(high))
    colours = vtk.vtkLookupTable()
    colours.SetHueRange(0.667, 0.0)
    colours.SetNumberOfTableValues(24)
    colours.SetRange(*bounds)
    colours.Build()
    deformed = warped(grid, factor)

    def fill(mapper, _):
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(variable)
        mapper.SetLookupTable(colours)
        mapper.SetScalarRange(*bounds)

    def line(mapper, item):
        mapper.ScalarVisibilityOff()
        item.GetProperty().SetColor(0.15, 0.15, 0.15)
        item.GetProperty().SetLineWidth(0.6)

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor(deformed, fill))
    renderer.AddActor(actor(edges(deformed), line))
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetTitle(variable)
    bar.SetNumberOfLabels(5)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0, 0, 0)
        text.ShadowOff()
        text.ItalicOff()
    bar.SetWidth(0.7)
    bar.SetHeight(0.5)
    bar.SetPosition(0.05, 0.25)
    legend = vtk.vtkRenderer()
    legend.SetViewport(0.88, 0, 1, 1)
    legend.SetBackground(1, 1, 1)
    legend.AddActor2D(bar)

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(1100, 900)
    window.AddRenderer(renderer)
    window.AddRenderer(legend)
    renderer.SetViewport(0, 0, 0.88, 1)
    renderer.ResetCamera()
    renderer.GetActiveCamera().ParallelProjectionOn()
    left, right, lower, upper = deformed_bounds(deformed)
    renderer.GetActiveCamera().SetParallelScale(0.53 * max(upper - lower, (right - left) * 900 / (0.88 * 1100)))
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3], float(sys.argv[4]), *sys.argv[5:7])
