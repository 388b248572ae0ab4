// decks/hertz.xml, finer towards the end of contact (near x = 0.05), where u - u(end) grows like r^1.5.
Point(1) = {0, -1, 0}; Point(2) = {1, -1, 0}; Point(3) = {1, 0, 0}; Point(4) = {0, 0, 0}; Point(5) = {1, 1, 0}; Point(6) = {0, 1, 0};
Point(7) = {0.1, 0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 7}; Line(4) = {7, 4}; Line(5) = {4, 1};
Line(6) = {3, 5}; Line(7) = {5, 6}; Line(8) = {6, 4};
Curve Loop(1) = {1, 2, 3, 4, 5}; Plane Surface(1) = {1};
Curve Loop(2) = {-4, -3, 6, 7, 8}; Plane Surface(2) = {2};
Physical Surface("block") = {1}; Physical Surface("cylinder") = {2};
Physical Curve("bottom") = {1}; Physical Curve("left") = {5, 8}; Physical Curve("contact") = {3, 4}; Physical Curve("top") = {7};

Field[1] = MathEval; Field[1].F = "0.15 * (0.05^2 * ((x - 0.05)^2 + y^2) + 1e-10)^0.25";
Field[2] = MathEval; Field[2].F = "0.15 * ((x - 0.05)^2 + y^2)^0.5";
Field[3] = Max; Field[3].FieldsList = {1, 2};
Background Field = 3;
Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0; Mesh.Algorithm = 6;
