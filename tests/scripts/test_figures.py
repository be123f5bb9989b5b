"""The figures of the structure: circles of imports are found where they are."""

from tests.packaging.loading import load

figures = load("scripts/figures.py")


def test_files_that_import_each_other_in_a_row_are_a_circle() -> None:
    edges = [("a/x", "a/y"), ("a/y", "b/z"), ("b/z", "a/x"), ("a/x", "c/w")]
    (circle,) = figures.import_cycles(edges)
    assert set(circle.split(" <- ")) == {"a/x", "a/y", "b/z"}


def test_folders_can_be_a_circle_where_no_files_are() -> None:
    edges = [("a/x", "b/z"), ("b/w", "a/y")]
    assert not figures.import_cycles(edges)
    (circle,) = figures.import_cycles(figures.siblings(edges))
    assert set(circle.split(" <- ")) == {"a", "b"}


def test_a_folder_and_what_it_holds_are_no_circle() -> None:
    edges = [("a", "a/x"), ("a/x", "a/y/z"), ("a/y/z", "a")]
    assert not figures.import_cycles(figures.siblings(edges))


def test_an_import_from_a_lower_folder_of_the_page_points_upwards() -> None:
    edges = [("kit/Button.tsx", "i18n/index.ts"), ("teacher/x.ts", "kit/Button.tsx")]
    edges += [("work/x.ts", "start/y.ts"), ("main.tsx", "frame/App.tsx")]
    assert figures.layer_violations(edges) == []
    assert figures.layer_violations([("kit/Button.tsx", "shell/route.ts")]) == [
        "kit/Button.tsx -> shell/route.ts"
    ]


def test_a_folder_of_the_page_that_the_order_does_not_name_holds_a_screen() -> None:
    edges = [
        ("about/x.tsx", "run/y.ts"),
        ("frame/App.tsx", "about/x.tsx"),
        ("about/x.ts", "work/y.ts"),
    ]
    assert figures.layer_violations(edges) == []
    assert figures.layer_violations([("run/y.ts", "about/x.tsx")]) == ["run/y.ts -> about/x.tsx"]


def test_the_longest_and_the_middle_of_lengths_are_told() -> None:
    assert figures.spread(range(1, 11)) == "median 5, p90 9, longest 10, 10 in all"
