import { Copy, Layers, Trash2 } from "lucide-preact";
import { WORLD_LIMITS } from "../api/declared";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Choice } from "../kit/Choice";
import { NumberField } from "../kit/NumberField";
import type { Area } from "../scene/areas";
import type { EditorStore } from "./editor_store";
import { clean, FINE, GRID } from "./geometry";
import {
  type AreaThing,
  isArea,
  ofKind,
  type Plan,
  type Start,
  type Thing,
  type Wall,
} from "./plan";
import { fromStart, onFloor, type Range, reach } from "./start_frame";
import { Swatches } from "./Toolbox";
import { nameOf } from "./words";

const { MAX_NAME, MAX_FLOOR_M, MIN_MOVABLE_SIDE_M, MIN_MOVABLE_KG, MAX_MOVABLE_KG } = WORLD_LIMITS;

interface PanelProps<T> {
  store: EditorStore;
  plan: Plan;
  thing: T;
}

/** Properties of the selected thing. */
export function ThingPanel({ store, plan, thing }: PanelProps<Thing>) {
  const words = texts.value.world;
  return (
    <section
      class="world-panel column grows shrinks-down gap-2"
      key={thing.id}
      data-testid="world-panel"
      data-kind={thing.kind}
    >
      <h2>{nameOf(thing, ofKind(plan, thing.kind).indexOf(thing), words)}</h2>
      {isArea(thing) ? (
        <AreaFields store={store} plan={plan} thing={thing} />
      ) : (
        <WallFields store={store} plan={plan} thing={thing} />
      )}
      <Acts store={store} thing={thing} />
    </section>
  );
}

function Acts({ store, thing }: { store: EditorStore; thing: Thing }) {
  const words = texts.value.world;
  return (
    <div class="world-panel__acts row wrap gap-2">
      {(thing.kind === "paint" || thing.kind === "zone") && (
        <Button icon={Layers} onPress={() => store.layer(true)}>
          {words.onTop}
        </Button>
      )}
      <Button icon={Copy} onPress={() => store.double()}>
        {words.double}
      </Button>
      <Button icon={Trash2} testId="world-delete" onPress={() => store.remove()}>
        {words.remove}
      </Button>
    </div>
  );
}

/** Setter for one number of a thing; consecutive changes of it are undone in one step. */
function measure(store: EditorStore, id: string, key: string) {
  return (changed: Thing | Start) => {
    if ("id" in changed) store.alter(changed, `${key} ${id}`);
    else store.place(changed, `${key} ${id}`);
  };
}

function WallFields({ store, plan, thing }: PanelProps<Wall>) {
  const words = texts.value.world;
  const end = (name: "from" | "to", axis: "x" | "y", label: string) => (
    <NumberField
      label={label}
      value={fromStart(plan.start, thing[name])[axis]}
      {...reach(plan, axis, GRID)}
      testId={`world-${name}-${axis}`}
      onNumber={(value) => {
        const counted = { ...fromStart(plan.start, thing[name]), [axis]: value };
        const place = onFloor(plan.start, counted);
        measure(store, thing.id, name + axis)({ ...thing, [name]: place });
      }}
    />
  );
  return (
    <>
      <p class="world-panel__hint">{words.fromStart}</p>
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

function AreaFields({ store, plan, thing }: PanelProps<AreaThing>) {
  const words = texts.value.world;
  const number = (key: keyof Area, label: string, range: Range, among: Partial<Area> = {}) => (
    <NumberField
      label={label}
      value={thing[key] ?? 0}
      {...range}
      testId={`world-${key}`}
      onNumber={(value) =>
        measure(store, thing.id, key)({ ...thing, ...among, [key]: value } as AreaThing)
      }
    />
  );
  const place = (axis: "x" | "y", label: string) => (
    <NumberField
      label={label}
      value={fromStart(plan.start, thing)[axis]}
      {...reach(plan, axis, GRID)}
      testId={`world-${axis}`}
      onNumber={(value) => {
        const counted = { ...fromStart(plan.start, thing), [axis]: value };
        measure(store, thing.id, axis)({ ...thing, ...onFloor(plan.start, counted) });
      }}
    />
  );
  const { heading } = plan.start;
  return (
    <>
      <OwnFields store={store} plan={plan} thing={thing} />
      {thing.kind !== "box" && <ShapeChoice store={store} thing={thing} />}
      <div class="numbers">
        {place("x", words.x)}
        {place("y", words.y)}
        {thing.radius !== null &&
          number("radius", words.radius, { ...SIDE, most: MAX_FLOOR_M / 2 })}
        {thing.radius === null && number("width", words.width, SIDE)}
        {thing.radius === null && number("depth", words.depth, SIDE)}
        {thing.radius === null && (
          <NumberField
            label={words.heading}
            value={clean(thing.heading - heading)}
            {...{ ...TURN, least: TURN.least - heading, most: TURN.most - heading }}
            testId="world-heading"
            onNumber={(turned) =>
              measure(store, thing.id, "heading")({ ...thing, heading: clean(turned + heading) })
            }
          />
        )}
        {thing.kind === "box" && thing.movable && <Mass store={store} thing={thing} />}
      </div>
      <p class="world-panel__hint">{words.fromStart}</p>
    </>
  );
}

const SIDE: Range = { least: MIN_MOVABLE_SIDE_M, most: MAX_FLOOR_M, step: GRID };
const TURN: Range = { least: -360, most: 360, step: 5 };
const MASS: Range = { least: MIN_MOVABLE_KG, most: MAX_MOVABLE_KG, step: 0.5 };
/** Mass of a box without a given mass, kilograms. */
const USUAL_MASS = 2;

function Mass({
  store,
  thing,
}: {
  store: EditorStore;
  thing: Extract<AreaThing, { kind: "box" }>;
}) {
  return (
    <NumberField
      label={texts.value.world.mass}
      value={thing.mass ?? USUAL_MASS}
      {...MASS}
      testId="world-mass"
      onNumber={(mass) => store.alter({ ...thing, mass }, `mass ${thing.id}`)}
    />
  );
}

function OwnFields({ store, thing }: PanelProps<AreaThing>) {
  const words = texts.value.world;
  if (thing.kind === "paint") {
    return <Swatches color={thing.color} onColor={(color) => store.dip(color)} />;
  }
  if (thing.kind === "zone") {
    return (
      <label class="world-panel__text">
        {words.zoneName}
        <input
          class="field"
          value={thing.name}
          maxLength={MAX_NAME}
          data-testid="world-zone-name"
          onInput={({ currentTarget: { value } }) =>
            store.alter({ ...thing, name: value }, `name ${thing.id}`)
          }
        />
      </label>
    );
  }
  return (
    <Choice
      label={words.kinds.box}
      testId="world-movable"
      options={[
        [false, words.fixed],
        [true, words.movable],
      ]}
      value={thing.movable}
      onChange={(movable) => store.alter({ ...thing, movable, mass: movable ? thing.mass : null })}
    />
  );
}

type Flat = Exclude<AreaThing, { kind: "box" }>;

function ShapeChoice({ store, thing }: { store: EditorStore; thing: Flat }) {
  const words = texts.value.world;
  return (
    <Choice
      label={words.shape}
      testId="world-shape"
      options={[
        ["rectangle", words.rectangle],
        ["disc", words.disc],
      ]}
      value={thing.radius === null ? "rectangle" : "disc"}
      onChange={(shape) => store.alter(shape === "disc" ? rounded(thing) : squared(thing))}
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

const across = (size: number): Range => ({ least: -size / 2, most: size / 2, step: GRID });

/** Properties of the start pose, counted from the middle of the floor: everything else is counted from the start. */
export function StartPanel({ store, plan }: { store: EditorStore; plan: Plan }) {
  const words = texts.value.world;
  const number = (key: keyof Start, label: string, range: Range) => (
    <NumberField
      label={label}
      value={plan.start[key]}
      {...range}
      testId={`world-${key}`}
      onNumber={(value) => measure(store, "start", key)({ ...plan.start, [key]: value })}
    />
  );
  return (
    <section
      class="world-panel column grows shrinks-down gap-2"
      data-testid="world-panel"
      data-kind="start"
    >
      <h2>{words.kinds.start}</h2>
      <p class="world-panel__hint">{words.startHint}</p>
      <div class="numbers">
        {number("x", words.x, across(plan.width))}
        {number("y", words.y, across(plan.depth))}
        {number("heading", words.heading, TURN)}
      </div>
    </section>
  );
}
