"""Synthetic workspaces, with edits, in Blockly's serialised form."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from random import Random
from typing import Any

Json = dict[str, Any]
Body = list["Sketch"]


@dataclass(eq=False)
class Sketch:
    """A block with fields, bodies, and inputs with a shadow number that a block may cover."""

    id: str
    type: str
    fields: Json = field(default_factory=dict)
    numbers: dict[str, float] = field(default_factory=dict)
    inside: dict[str, "Sketch"] = field(default_factory=dict)
    bodies: dict[str, Body] = field(default_factory=dict)
    shape: Json = field(default_factory=dict)
    comment: str = ""
    off: bool = False

    def saved(self) -> Json:
        state: Json = {"type": self.type, "id": self.id, "inputs": {}}
        if self.fields:
            state["fields"] = dict(self.fields)
        for name, number in self.numbers.items():
            shadow = {"type": "number", "id": f"{self.id}/{name}", "fields": {"NUM": number}}
            state["inputs"][name] = {"shadow": shadow}
            if name in self.inside:
                state["inputs"][name]["block"] = self.inside[name].saved()
        for name, body in self.bodies.items():
            if body:
                state["inputs"][name] = {"block": stacked(body)}
        if self.shape:
            state["extraState"] = dict(self.shape)
        if self.comment:
            state["icons"] = {"comment": {"text": self.comment, "height": 100}}
        if self.off:
            state["disabledReasons"] = ["MANUALLY_DISABLED"]
        return state

    def all(self) -> Iterator["Sketch"]:
        """The block and all nested blocks."""
        yield self
        for block in [
            *self.inside.values(),
            *(one for body in self.bodies.values() for one in body),
        ]:
            yield from block.all()

    @property
    def is_leaf(self) -> bool:
        return not self.inside and not any(self.bodies.values())


def stacked(body: Body) -> Json:
    """Blocks one below the other."""
    first: Json = {}
    for block in reversed(body):
        state = block.saved()
        first = {**state, "next": {"block": first}} if first else state
    return first


def workspace_of(*stacks: Body) -> Json:
    return {"blocks": {"languageVersion": 0, "blocks": [stacked(body) for body in stacks if body]}}


def move(block_id: str = "m", metres: float = 1) -> Sketch:
    return Sketch(block_id, "move_forward", numbers={"DISTANCE": metres})


def start(block_id: str = "start") -> Sketch:
    return Sketch(block_id, "program_start")


class Drawing:
    """A random workspace with random edits, which records the expected differences."""

    def __init__(self, random: Random) -> None:
        self.random = random
        self.count = 0
        self.stacks: list[Body] = [[start()]]
        self.stacks += [[self._fresh()] for _ in range(random.randrange(3))]
        for _ in range(random.randrange(25)):
            random.choice(self.bodies()).append(self._fresh())
        self.added: set[str] = set()
        self.removed: set[str] = set()
        self.changed: set[str] = set()
        self.moved: set[str] = set()

    def saved(self) -> Json:
        return workspace_of(*self.stacks)

    def edit(self) -> None:
        """Edits one block that was not edited before."""
        self.random.choice((self._add, self._remove, self._change, self._move))()

    def bodies(self) -> list[Body]:
        """All sequences into which a block can be inserted."""
        inner = [body for block in self.blocks() for body in block.bodies.values()]
        return [*self.stacks, *inner]

    def blocks(self) -> list[Sketch]:
        return [one for stack in self.stacks for block in stack for one in block.all()]

    def _fresh(self) -> Sketch:
        self.count += 1
        name, random = f"b{self.count}", self.random
        kind = random.choice(("move_forward", "repeat", "say", "if"))
        block = Sketch(name, kind, shape={"n": random.randrange(3)} if kind == "if" else {})
        if kind == "say":
            block.fields = {"TEXT": "olá"}
        else:
            block.numbers = {"AMOUNT": random.randrange(9)}
        if kind in ("repeat", "if"):
            block.bodies = {"DO": []}
        if block.numbers and random.random() < 0.3:
            block.inside["AMOUNT"] = Sketch(f"v{self.count}", "get_variable", {"NAME": "n"})
        return block

    def _add(self) -> None:
        block = self._fresh()
        body = self.random.choice(self.bodies())
        body.insert(self.random.randint(body is self.stacks[0], len(body)), block)
        self.added |= {one.id for one in block.all()}

    def _remove(self) -> None:
        choice = [(body, one) for body in self.bodies() for one in body if self._untouched(one)]
        choice = [(body, one) for body, one in choice if one.is_leaf]
        if choice:
            body, block = self.random.choice(choice)
            body.remove(block)
            self.removed.add(block.id)

    def _change(self) -> None:
        choice = [one for one in self.blocks() if self._untouched(one)]
        if not choice:
            return
        block = self.random.choice(choice)
        match self.random.randrange(5):
            case 0 if block.fields:
                block.fields[next(iter(block.fields))] = "adeus"
            case 1 if block.numbers and not block.inside:
                block.numbers["AMOUNT"] += 0.5
            case 2 if block.shape:
                block.shape["n"] = True
            case 3:
                block.off = True
            case _:
                block.comment = "por quê?"
        self.changed.add(block.id)

    def _move(self) -> None:
        """Moves a block into the body of another, without further changes."""
        choice = [
            (here, block, there)
            for here in self.bodies()
            for block in here
            if self._untouched(block)
            for there in self.bodies()
            if there is not here and not any(there is stack for stack in self.stacks[1:])
            if not any(there is body for one in block.all() for body in one.bodies.values())
        ]
        if choice:
            here, block, there = self.random.choice(choice)
            here.remove(block)
            there.insert(self.random.randint(there is self.stacks[0], len(there)), block)
            self.moved.add(block.id)

    def _untouched(self, block: Sketch) -> bool:
        touched = self.added | self.removed | self.changed | self.moved
        return block.id not in touched and block.type != "program_start"
