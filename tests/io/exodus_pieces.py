"""Pieces of an Exodus file compared with the file that they are pieces of, by netCDF alone."""

import netCDF4
import numpy


def open_file(path):
    file = netCDF4.Dataset(path)
    file.set_auto_mask(False)
    return file


def texts(file, variable):
    return [row.tobytes().split(b"\0")[0].decode() for row in file[variable][:]] if variable in file.variables else []


def numbers(file, variable):
    return file[variable][:] if variable in file.variables else numpy.zeros(0, int)


class Piece:
    """One piece with its maps to the whole; all numbers from 0."""

    def __init__(self, path):
        self.file = open_file(path)
        self.pieces, self.number = (int(part) for part in str(path).rsplit(".", 2)[1:])
        self.nodes, self.elements = numbers(self.file, "node_num_map") - 1, numbers(self.file, "elem_num_map") - 1
        self.axes = "xyz"[: self.file.dimensions["num_dim"].size]
        self.blocks = len(texts(self.file, "eb_names"))
        self.sets = len(texts(self.file, "ss_names"))

    def elements_of(self, block):
        """Their numbers in the piece."""
        counts = [len(numbers(self.file, f"connect{b + 1}")) for b in range(self.blocks)]
        return numpy.arange(counts[block]) + sum(counts[:block])

    def maps(self, kind):
        """{other piece: columns} of the communication maps of nodes ("n") or elements ("e")."""
        ids, ends = numbers(self.file, f"{kind}_comm_ids"), numbers(self.file, f"{kind}_comm_data_idx")
        begins = [0, *ends[:-1]]
        names = ["n_comm_nids", "n_comm_proc"] if kind == "n" else ["e_comm_eids", "e_comm_sids", "e_comm_proc"]
        found = {}
        for begin, end in zip(begins, ends):
            *columns, owners = (self.file[name][begin:end] for name in names)
            assert len(set(owners)) == 1, owners
            found[int(owners[0])] = columns
        assert len(found) == len(ids)
        return found


def same(ours, theirs, what, tolerance=None):
    """Bit by bit; with a tolerance, up to this part of the largest value."""
    ours, theirs = numpy.asarray(ours), numpy.asarray(theirs)
    assert ours.shape == theirs.shape and ours.dtype == theirs.dtype, what
    if tolerance is None:
        assert ours.tobytes() == theirs.tobytes(), what
    else:
        assert numpy.allclose(ours, theirs, rtol=0, atol=tolerance * numpy.nanmax(numpy.abs(theirs), initial=0) + 1e-12,
                              equal_nan=True), what


class Pieces:
    """All pieces of a scene, and what they say of each other."""

    def __init__(self, pieces):
        self.pieces = sorted((Piece(path) for path in pieces), key=lambda p: p.number)
        assert [p.number for p in self.pieces] == list(range(self.pieces[0].pieces))
        sizes = self.pieces[0].file.dimensions
        owners = numpy.zeros(sizes["num_elems_global"].size, int)
        for piece in self.pieces:
            owners[piece.elements] += 1
        assert (owners == 1).all(), "every element is in one piece"
        assert set(numpy.concatenate([p.nodes for p in self.pieces])) == set(range(sizes["num_nodes_global"].size))

    def check_maps(self):
        """What two pieces say they share is what they share, in the same order on both sides."""
        facets = [self.facets_of(piece) for piece in self.pieces]
        for piece in self.pieces:
            maps, border = piece.maps("n"), set()
            for other in self.pieces:
                common = numpy.intersect1d(piece.nodes, other.nodes)
                if other is piece or common.size == 0:
                    assert other.number not in maps
                    continue
                mine = piece.nodes[maps[other.number][0] - 1]
                assert list(mine) == list(common)
                self.compare_common(piece, other, common)
                border |= set(maps[other.number][0])
            assert border == set(numbers(piece.file, "node_mapb"))
            inner = set(numbers(piece.file, "node_mapi"))
            assert not inner & border and inner | border == set(range(1, len(piece.nodes) + 1))
            self.check_facets(piece, facets)

    def compare_common(self, piece, other, common):
        """Nodes of several pieces have the same place and the same values in all of them, bit by bit."""
        names = [f"coord{axis}" for axis in piece.axes]
        names += [f"vals_nod_var{v + 1}" for v in range(len(texts(piece.file, "name_nod_var")))]
        for name in names:
            ours, theirs = (p.file[name][:][..., numpy.searchsorted(p.nodes, common)] for p in (piece, other))
            same(ours, theirs, f"{name} on common nodes")

    def check_facets(self, piece, facets):
        """facets: per piece all that it has."""
        maps, border = piece.maps("e"), set()
        for number, (elements, sides) in maps.items():
            back = self.pieces[number].maps("e")[piece.number]
            mine = [self.facet(piece, e, s) for e, s in zip(elements, sides)]
            assert len(set(mine)) == len(mine)
            assert mine == [self.facet(self.pieces[number], e, s) for e, s in zip(*back)]
            border |= set(elements)
        for other in self.pieces:
            both = facets[piece.number] & facets[other.number] if other is not piece else set()
            listed = zip(*maps[other.number]) if other.number in maps else []
            assert both == {self.facet(piece, e, s) for e, s in listed}, "facets of two pieces are in their maps"
        assert border == set(numbers(piece.file, "elem_mapb"))

    SIDES = {2: ((0, 1), (1, 2), (2, 0)), 3: ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1))}

    def facets_of(self, piece):
        sides = self.SIDES[len(piece.axes)]
        return {tuple(sorted(int(node) for node in piece.nodes[nodes[list(side)] - 1]))
                for b in range(piece.blocks) for nodes in numbers(piece.file, f"connect{b + 1}") for side in sides}

    def facet(self, piece, element, side):
        """The vertices in the whole."""
        for b in range(piece.blocks):
            own = piece.elements_of(b)
            if own.size and own[0] <= element - 1 <= own[-1]:
                nodes = piece.file[f"connect{b + 1}"][element - 1 - own[0]]
                return tuple(sorted(int(piece.nodes[nodes[v] - 1]) for v in self.SIDES[len(piece.axes)][side - 1]))
        raise AssertionError(f"no element {element}")


class Join(Pieces):
    """Everything of the whole, gathered from its pieces and compared; values up to a tolerance where another run has written the whole."""

    def __init__(self, whole, pieces, tolerance=None):
        super().__init__(pieces)
        self.tolerance, self.whole = tolerance, open_file(whole)

    def compare(self):
        for names in ("eb_names", "ss_names", "coor_names", "name_nod_var", "name_elem_var", "name_sset_var", "name_glo_var",
                      "info_records"):
            for piece in self.pieces:
                assert texts(piece.file, names) == texts(self.whole, names), names
        for piece in self.pieces:
            same(piece.file["time_whole"][:], self.whole["time_whole"][:], "times")
            if "vals_glo_var" in self.whole.variables:
                same(piece.file["vals_glo_var"][:], self.whole["vals_glo_var"][:], "global", self.tolerance)
            self.compare_nodes(piece)
            self.compare_elements(piece)
            self.check_records(piece)
        self.compare_sets()
        self.check_maps()

    def compare_nodes(self, piece):
        assert (numpy.diff(piece.nodes) > 0).all()
        for axis in piece.axes:
            same(numbers(piece.file, f"coord{axis}"), self.whole[f"coord{axis}"][:][piece.nodes], axis)
        for v in range(len(texts(self.whole, "name_nod_var"))):
            values = f"vals_nod_var{v + 1}"
            same(piece.file[values][:], self.whole[values][:][:, piece.nodes], values, self.tolerance)

    def compare_elements(self, piece):
        first = 0
        for b in range(piece.blocks):
            mine, name = piece.elements[piece.elements_of(b)], f"connect{b + 1}"
            count = len(self.whole[name][:])
            assert ((mine >= first) & (mine < first + count)).all(), "elements are in the whole's block"
            if len(mine) > 0:
                same(piece.nodes[piece.file[name][:] - 1], (self.whole[name][:] - 1)[mine - first].astype(piece.nodes.dtype), name)
                assert piece.file[name].elem_type == self.whole[name].elem_type
            for v in range(len(texts(self.whole, "name_elem_var"))):
                values = f"vals_elem_var{v + 1}eb{b + 1}"
                assert (values in piece.file.variables) == (len(mine) > 0) == bool(piece.file["elem_var_tab"][b, v])
                if len(mine) > 0:
                    same(piece.file[values][:], self.whole[values][:][:, mine - first], values, self.tolerance)
            first += count

    def compare_sets(self):
        for s in range(1, self.pieces[0].sets + 1):
            whole = {(e, i): n for n, (e, i) in enumerate(zip(numbers(self.whole, f"elem_ss{s}"), numbers(self.whole, f"side_ss{s}")))}
            seen = []
            for piece in self.pieces:
                elements = piece.elements[numbers(piece.file, f"elem_ss{s}") - 1] + 1
                places = [whole[key] for key in zip(elements, numbers(piece.file, f"side_ss{s}"))]
                seen += places
                for v in range(len(texts(self.whole, "name_sset_var"))):
                    values = f"vals_sset_var{v + 1}ss{s}"
                    if values in self.whole.variables and places:
                        same(piece.file[values][:], self.whole[values][:][:, places], values, self.tolerance)
            assert sorted(seen) == list(range(len(whole))), f"facets of side set {s}"

    def check_records(self, piece):
        """Nemesis's sizes and lists."""
        sizes = piece.file.dimensions
        assert sizes["num_processors"].size == len(self.pieces) and sizes["num_procs_file"].size == 1
        assert sizes["num_nodes_global"].size == self.whole.dimensions["num_nodes"].size
        assert sizes["num_elems_global"].size == self.whole.dimensions["num_elem"].size
        assert list(piece.file["el_blk_cnt_global"][:]) == [len(self.whole[f"connect{b + 1}"][:]) for b in range(piece.blocks)]
        if piece.sets:
            assert list(piece.file["ss_side_cnt_global"][:]) == [len(numbers(self.whole, f"elem_ss{s + 1}")) for s in range(piece.sets)]
        nodes = sorted([*numbers(piece.file, "node_mapi"), *numbers(piece.file, "node_mapb")])
        assert nodes == list(range(1, len(piece.nodes) + 1))
        elements = sorted([*numbers(piece.file, "elem_mapi"), *numbers(piece.file, "elem_mapb")])
        assert elements == list(range(1, len(piece.elements) + 1))
