// A block, 0.9 x 0.6 x 0.6, turned about the vertical axis; it stands on the plate of blocks-plate.geo.
SetFactory("OpenCASCADE");
Box(1) = {-0.45, -0.3, 0, 0.9, 0.6, 0.6};
Rotate {{0, 0, 1}, {0, 0, 0}, Pi / 7} { Volume{1}; }
Physical Volume("block") = {1};
Physical Surface("sole") = {5};
Physical Surface("head") = {6};
Mesh.MeshSizeMax = 0.25;
