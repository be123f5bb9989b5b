import { Copy, Layers, Trash2 } from "lucide-preact";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { Choice } from "./Choice";
import type { WorldDesk } from "./desk";
import { clean, FINE, GRID } from "./geometry";
import { LONGEST, NAME_MOST, PUSHED_LEAST_KG, PUSHED_MOST_KG, SHORTEST } from "./limits";
import { NumberField } from "./NumberField";
import {
  type Area,
  type AreaThing,
  isArea,
  ofKind,
  type Plan,
  type Start,
  type Thing,
  type Wall,
} from "./plan";
import { Swatches } from "./Toolbox";
import { nameOf } from "./words";

interface PanelProps<T> {
  desk: WorldDesk;
  plan: Plan;
  thing: T;
}

/** The selected thing in numbers. */
export function ThingPanel({ desk, plan, thing }: PanelProps<Thing>) {
  const words = texts.value.world;
  return (
    <section
      class="world-panel"
      key={thing.id}
      data-testid={TEST.worldPanel}
      data-kind={thing.kind}
    >
      <h2>{nameOf(thing, ofKind(plan, thing.kind).indexOf(thing), words)}</h2>
      {isArea(thing) ? (
        <AreaFields desk={desk} plan={plan} thing={thing} />
      ) : (
        <WallFields desk={desk} plan={plan} thing={thing} />
      )}
      <Acts desk={desk} thing={thing} />
    </section>
  );
}

function Acts({ desk, thing }: { desk: WorldDesk; thing: Thing }) {
  const words = texts.value.world;
  return (
    <div class="world-panel__acts">
      {(thing.kind === "paint" || thing.kind === "zone") && (
        <button type="button" class="button" onClick={() => desk.layer(true)}>
          <Layers class="icon" aria-hidden="true" />
          {words.onTop}
        </button>
      )}
      <button type="button" class="button" onClick={() => desk.double()}>
        <Copy class="icon" aria-hidden="true" />
        {words.double}
      </button>
      <button
        type="button"
        class="button"
        data-testid={TEST.worldDelete}
        onClick={() => desk.remove()}
      >
        <Trash2 class="icon" aria-hidden="true" />
        {words.remove}
      </button>
    </div>
  );
}

/** A number of a thing; typing one number after another is undone at once. */
function measure(desk: WorldDesk, id: string, key: string) {
  return (changed: Thing | Start) => {
    if ("id" in changed) desk.alter(changed, `${key} ${id}`);
    else desk.place(changed, `${key} ${id}`);
  };
}

function WallFields({ desk, plan, thing }: PanelProps<Wall>) {
  const words = texts.value.world;
  const end = (name: "from" | "to", axis: "x" | "y", label: string) => (
    <NumberField
      label={label}
      value={thing[name][axis]}
      {...reach(axis === "x" ? plan.width : plan.depth)}
      testId={`world-${name}-${axis}`}
      onNumber={(value) =>
        measure(
          desk,
          thing.id,
          name + axis,
        )({ ...thing, [name]: { ...thing[name], [axis]: value } })
      }
    />
  );
  return (
    <>
      <h3>{words.oneEnd}</h3>
      <div class="numbers">
        {end("from", "x", words.x)}
        {end("from", "y", words.y)}
      </div>
      <h3>{words.otherEnd}</h3>
      <div class="numbers">
        {end("to", "x", words.x)}
        {end("to", "y", words.y)}
      </div>
    </>
  );
}

const reach = (size: number) => ({ least: -size / 2, most: size / 2, step: GRID });

function AreaFields({ desk, plan, thing }: PanelProps<AreaThing>) {
  const words = texts.value.world;
  const number = (key: keyof Area, label: string, range: Range, among: Partial<Area> = {}) => (
    <NumberField
      label={label}
      value={thing[key] ?? 0}
      {...range}
      testId={`world-${key}`}
      onNumber={(value) =>
        measure(desk, thing.id, key)({ ...thing, ...among, [key]: value } as AreaThing)
      }
    />
  );
  return (
    <>
      <OwnFields desk={desk} plan={plan} thing={thing} />
      {thing.kind !== "box" && <ShapeChoice desk={desk} thing={thing} />}
      <div class="numbers">
        {number("x", words.x, reach(plan.width))}
        {number("y", words.y, reach(plan.depth))}
        {thing.radius !== null && number("radius", words.radius, { ...SIDE, most: LONGEST / 2 })}
        {thing.radius === null && number("width", words.width, SIDE)}
        {thing.radius === null && number("depth", words.depth, SIDE)}
        {thing.radius === null && number("heading", words.heading, TURN)}
        {thing.kind === "box" && thing.movable && <Mass desk={desk} thing={thing} />}
      </div>
    </>
  );
}

interface Range {
  least: number;
  most: number;
  step: number;
}
const SIDE: Range = { least: SHORTEST, most: LONGEST, step: GRID };
const TURN: Range = { least: -360, most: 360, step: 5 };
const MASS: Range = { least: PUSHED_LEAST_KG, most: PUSHED_MOST_KG, step: 0.5 };
/** What a box weighs that nobody has weighed, kilograms. */
const USUAL_MASS = 2;

function Mass({ desk, thing }: { desk: WorldDesk; thing: Extract<AreaThing, { kind: "box" }> }) {
  return (
    <NumberField
      label={texts.value.world.mass}
      value={thing.mass ?? USUAL_MASS}
      {...MASS}
      testId="world-mass"
      onNumber={(mass) => desk.alter({ ...thing, mass }, `mass ${thing.id}`)}
    />
  );
}

function OwnFields({ desk, thing }: PanelProps<AreaThing>) {
  const words = texts.value.world;
  if (thing.kind === "paint") {
    return <Swatches color={thing.color} onColor={(color) => desk.dip(color)} />;
  }
  if (thing.kind === "zone") {
    return (
      <label class="world-panel__text">
        {words.zoneName}
        <input
          class="field"
          value={thing.name}
          maxLength={NAME_MOST}
          data-testid={TEST.worldZoneName}
          onInput={({ currentTarget: { value } }) =>
            desk.alter({ ...thing, name: value }, `name ${thing.id}`)
          }
        />
      </label>
    );
  }
  return (
    <Choice
      label={words.kinds.box}
      testId={TEST.worldMovable}
      options={[
        [false, words.fixed],
        [true, words.movable],
      ]}
      value={thing.movable}
      onValue={(movable) => desk.alter({ ...thing, movable, mass: movable ? thing.mass : null })}
    />
  );
}

type Flat = Exclude<AreaThing, { kind: "box" }>;

function ShapeChoice({ desk, thing }: { desk: WorldDesk; thing: Flat }) {
  const words = texts.value.world;
  return (
    <Choice
      label={words.shape}
      testId={TEST.worldShape}
      options={[
        ["rectangle", words.rectangle],
        ["disc", words.disc],
      ]}
      value={thing.radius === null ? "rectangle" : "disc"}
      onValue={(shape) => desk.alter(shape === "disc" ? rounded(thing) : squared(thing))}
    />
  );
}

function rounded(thing: Flat): Flat {
  const radius = Math.max(FINE, clean(Math.min(thing.width, thing.depth) / 2));
  return { ...thing, radius, heading: 0 };
}

function squared(thing: Flat): Flat {
  const side = clean(2 * (thing.radius ?? thing.width / 2));
  return { ...thing, radius: null, width: side, depth: side };
}

/** Where the robot begins. */
export function StartPanel({ desk, plan }: { desk: WorldDesk; plan: Plan }) {
  const words = texts.value.world;
  const number = (key: keyof Start, label: string, range: Range) => (
    <NumberField
      label={label}
      value={plan.start[key]}
      {...range}
      testId={`world-${key}`}
      onNumber={(value) => measure(desk, "start", key)({ ...plan.start, [key]: value })}
    />
  );
  return (
    <section class="world-panel" data-testid={TEST.worldPanel} data-kind="start">
      <h2>{words.kinds.start}</h2>
      <p class="world-panel__hint">{words.startHint}</p>
      <div class="numbers">
        {number("x", words.x, reach(plan.width))}
        {number("y", words.y, reach(plan.depth))}
        {number("heading", words.heading, TURN)}
      </div>
    </section>
  );
}
