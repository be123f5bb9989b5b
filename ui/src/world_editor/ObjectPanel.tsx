import { Copy, Layers, Trash2 } from "lucide-preact";
import { WORLD_LIMITS } from "../api/declared";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { NumberField } from "../kit/NumberField";
import { RadioGroup } from "../kit/RadioGroup";
import type { Area } from "../scene/areas";
import { hasColour } from "../scene/mat/prints";
import { BoxKindField, PrintField } from "./AppearanceFields";
import type { EditorStore } from "./editor_store";
import { clean, FINE, GRID } from "./geometry";
import { nameOf } from "./labels";
import {
  type AreaObject,
  type FloorPlan,
  isArea,
  ofKind,
  type Print,
  type Start,
  type Wall,
  type WorldObject,
} from "./plan";
import { fromStart, onFloor, type Range, reach } from "./start_frame";
import { Swatches } from "./Toolbox";

const { MAX_NAME, MAX_FLOOR_M, MIN_MOVABLE_SIDE_M, MIN_MOVABLE_KG, MAX_MOVABLE_KG } = WORLD_LIMITS;

interface PanelProps<T> {
  store: EditorStore;
  plan: FloorPlan;
  object: T;
}

/** Properties of the selected object. */
export function ObjectPanel({ store, plan, object }: PanelProps<WorldObject>) {
  const labels = texts.value.world;
  return (
    <section
      class="world-panel column grows shrinks-down gap-2"
      key={object.id}
      data-testid="world-panel"
      data-kind={object.kind}
    >
      <h2>{nameOf(object, ofKind(plan, object.kind).indexOf(object), labels)}</h2>
      {isArea(object) ? (
        <AreaFields store={store} plan={plan} object={object} />
      ) : (
        <WallFields store={store} plan={plan} object={object} />
      )}
      <Acts store={store} object={object} />
    </section>
  );
}

function Acts({ store, object }: { store: EditorStore; object: WorldObject }) {
  const labels = texts.value.world;
  return (
    <div class="world-panel__acts row wrap gap-2">
      {(object.kind === "paint" || object.kind === "zone" || object.kind === "print") && (
        <Button icon={Layers} onPress={() => store.layer(true)}>
          {labels.onTop}
        </Button>
      )}
      <Button icon={Copy} onPress={() => store.double()}>
        {labels.double}
      </Button>
      <Button icon={Trash2} testId="world-delete" onPress={() => store.remove()}>
        {labels.remove}
      </Button>
    </div>
  );
}

/** Setter for one number of an object; consecutive changes of the number are undone in one step. */
function measure(store: EditorStore, id: string, key: string) {
  return (changed: WorldObject | Start) => {
    if ("id" in changed) store.alter(changed, `${key} ${id}`);
    else store.setStart(changed, `${key} ${id}`);
  };
}

function WallFields({ store, plan, object }: PanelProps<Wall>) {
  const labels = texts.value.world;
  const end = (name: "from" | "to", axis: "x" | "y", label: string) => (
    <NumberField
      label={label}
      value={fromStart(plan.start, object[name])[axis]}
      {...reach(plan, axis, GRID)}
      testId={`world-${name}-${axis}`}
      onNumber={(value) => {
        const counted = { ...fromStart(plan.start, object[name]), [axis]: value };
        const place = onFloor(plan.start, counted);
        measure(store, object.id, name + axis)({ ...object, [name]: place });
      }}
    />
  );
  return (
    <>
      <p class="world-panel__hint">{labels.fromStart}</p>
      <h3>{labels.oneEnd}</h3>
      <div class="numbers">
        {end("from", "x", labels.x)}
        {end("from", "y", labels.y)}
      </div>
      <h3>{labels.otherEnd}</h3>
      <div class="numbers">
        {end("to", "x", labels.x)}
        {end("to", "y", labels.y)}
      </div>
    </>
  );
}

function AreaFields({ store, plan, object }: PanelProps<AreaObject>) {
  const labels = texts.value.world;
  const number = (key: keyof Area, label: string, range: Range, among: Partial<Area> = {}) => (
    <NumberField
      label={label}
      value={object[key] ?? 0}
      {...range}
      testId={`world-${key}`}
      onNumber={(value) =>
        measure(store, object.id, key)({ ...object, ...among, [key]: value } as AreaObject)
      }
    />
  );
  const place = (axis: "x" | "y", label: string) => (
    <NumberField
      label={label}
      value={fromStart(plan.start, object)[axis]}
      {...reach(plan, axis, GRID)}
      testId={`world-${axis}`}
      onNumber={(value) => {
        const counted = { ...fromStart(plan.start, object), [axis]: value };
        measure(store, object.id, axis)({ ...object, ...onFloor(plan.start, counted) });
      }}
    />
  );
  const { heading } = plan.start;
  return (
    <>
      <OwnFields store={store} plan={plan} object={object} />
      {(object.kind === "zone" || object.kind === "paint") && (
        <ShapeChoice store={store} object={object} />
      )}
      <div class="numbers">
        {place("x", labels.x)}
        {place("y", labels.y)}
        {object.radius !== null &&
          number("radius", labels.radius, { ...SIDE, max: MAX_FLOOR_M / 2 })}
        {object.radius === null && number("width", labels.width, SIDE)}
        {object.radius === null && number("depth", labels.depth, SIDE)}
        {object.radius === null && (
          <NumberField
            label={labels.heading}
            value={clean(object.heading - heading)}
            {...{ ...TURN, min: TURN.min - heading, max: TURN.max - heading }}
            testId="world-heading"
            onNumber={(turned) =>
              measure(store, object.id, "heading")({ ...object, heading: clean(turned + heading) })
            }
          />
        )}
        {object.kind === "box" && object.movable && <Mass store={store} object={object} />}
      </div>
      <p class="world-panel__hint">{labels.fromStart}</p>
    </>
  );
}

const SIDE: Range = { min: MIN_MOVABLE_SIDE_M, max: MAX_FLOOR_M, step: GRID };
const TURN: Range = { min: -360, max: 360, step: 5 };
const MASS: Range = { min: MIN_MOVABLE_KG, max: MAX_MOVABLE_KG, step: 0.5 };
/** Default mass of a box, kilograms. */
const USUAL_MASS = 2;

function Mass({
  store,
  object,
}: {
  store: EditorStore;
  object: Extract<AreaObject, { kind: "box" }>;
}) {
  return (
    <NumberField
      label={texts.value.world.mass}
      value={object.mass ?? USUAL_MASS}
      {...MASS}
      testId="world-mass"
      onNumber={(mass) => store.alter({ ...object, mass }, `mass ${object.id}`)}
    />
  );
}

function OwnFields({ store, object }: PanelProps<AreaObject>) {
  const labels = texts.value.world;
  if (object.kind === "paint") {
    return <Swatches color={object.color} onColor={(color) => store.setPaint(color)} />;
  }
  if (object.kind === "zone") {
    return (
      <label class="world-panel__text">
        {labels.zoneName}
        <input
          class="field"
          value={object.name}
          maxLength={MAX_NAME}
          data-testid="world-zone-name"
          onInput={({ currentTarget: { value } }) =>
            store.alter({ ...object, name: value }, `name ${object.id}`)
          }
        />
      </label>
    );
  }
  if (object.kind === "print") return <PrintFields store={store} object={object} />;
  return (
    <>
      <BoxKindField
        value={object.boxKind}
        onChange={(boxKind) => store.alter({ ...object, boxKind })}
      />
      <RadioGroup
        label={labels.kinds.box}
        testId="world-movable"
        options={[
          [false, labels.fixed],
          [true, labels.movable],
        ]}
        value={object.movable}
        onChange={(movable) =>
          store.alter({ ...object, movable, mass: movable ? object.mass : null })
        }
      />
    </>
  );
}

function PrintFields({ store, object }: { store: EditorStore; object: Print }) {
  return (
    <>
      <PrintField
        value={object.print}
        onChange={(print) => store.alter({ ...object, print, color: null })}
      />
      {hasColour(object.print) && (
        <Swatches
          label={texts.value.world.printColor}
          color={object.color}
          onColor={(color) => store.alter({ ...object, color })}
        />
      )}
    </>
  );
}

type Flat = Extract<AreaObject, { kind: "zone" | "paint" }>;

function ShapeChoice({ store, object }: { store: EditorStore; object: Flat }) {
  const labels = texts.value.world;
  return (
    <RadioGroup
      label={labels.shape}
      testId="world-shape"
      options={[
        ["rectangle", labels.rectangle],
        ["disc", labels.disc],
      ]}
      value={object.radius === null ? "rectangle" : "disc"}
      onChange={(shape) => store.alter(shape === "disc" ? rounded(object) : squared(object))}
    />
  );
}

function rounded(object: Flat): Flat {
  const radius = Math.max(FINE, clean(Math.min(object.width, object.depth) / 2));
  return { ...object, radius, heading: 0 };
}

function squared(object: Flat): Flat {
  const side = clean(2 * (object.radius ?? object.width / 2));
  return { ...object, radius: null, width: side, depth: side };
}

const across = (size: number): Range => ({ min: -size / 2, max: size / 2, step: GRID });

/** Properties of the start pose, in the world frame. All other objects have coordinates in the start frame. */
export function StartPanel({ store, plan }: { store: EditorStore; plan: FloorPlan }) {
  const labels = texts.value.world;
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
      <h2>{labels.kinds.start}</h2>
      <p class="world-panel__hint">{labels.startHint}</p>
      <div class="numbers">
        {number("x", labels.x, across(plan.width))}
        {number("y", labels.y, across(plan.depth))}
        {number("heading", labels.heading, TURN)}
      </div>
    </section>
  );
}
