// A plate, 2 x 2 x 0.5; its upper side is the table on which the block of blocks-block.geo stands.
SetFactory("OpenCASCADE");
Box(1) = {-1, -1, -0.5, 2, 2, 0.5};
Physical Volume("plate") = {1};
Physical Surface("table") = {6};
Physical Surface("base") = {5};
Mesh.MeshSizeMax = 0.4;
