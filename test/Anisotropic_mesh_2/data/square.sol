MeshVersionFormatted 2

Dimension 2

SolAtVertices
5
1 3

4 0 1
4 0.5 1
1 0 4
2 -0.25 2
1e2 0 1e-2

End
