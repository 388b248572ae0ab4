// decks/contact-loss.xml, finer towards the end of contact (near x = 0.957), the end of the load and the clamped corner.
Point(1) = {0, -2, 0}; Point(2) = {2, -2, 0}; Point(3) = {2, 0, 0}; Point(4) = {1, 0, 0};
Point(5) = {0, 0, 0}; Point(6) = {1, 0.8, 0}; Point(7) = {0.5, 0.8, 0}; Point(8) = {0, 0.8, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 1};
Line(6) = {4, 6}; Line(7) = {6, 7}; Line(8) = {7, 8}; Line(9) = {8, 5};
Curve Loop(1) = {1, 2, 3, 4, 5}; Plane Surface(1) = {1};
Curve Loop(2) = {-4, 6, 7, 8, 9}; Plane Surface(2) = {2};
Physical Surface("lower") = {1}; Physical Surface("upper") = {2};
Physical Curve("bottom") = {1}; Physical Curve("left") = {5, 9}; Physical Curve("contact") = {4}; Physical Curve("loaded") = {8};

Field[1] = MathEval; Field[1].F = "0.1 * ((x - 0.957)^2 + y^2 + 1e-6)^0.25";
Field[2] = MathEval; Field[2].F = "0.1 * ((x - 0.5)^2 + (y - 0.8)^2 + 1e-9)^0.333";
Field[3] = MathEval; Field[3].F = "0.4 * ((x - 2)^2 + (y + 2)^2 + 1e-9)^0.37";
Field[4] = Min; Field[4].FieldsList = {1, 2, 3};
Background Field = 4;
Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0; Mesh.Algorithm = 6;
