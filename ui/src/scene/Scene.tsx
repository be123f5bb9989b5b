import type { ReadonlySignal } from "@preact/signals";
import { effect, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Robot, World } from "../api/model";
import { language, texts } from "../i18n";
import { degrees, headingDegrees, metres } from "../i18n/format";
import { useInstance } from "../kit/instance";
import { listen } from "../kit/listen";
import { showBeeps } from "../run/beep_sign";
import type { DialogueLine } from "../run/output";
import type { Pose, RunView } from "../run/reducer";
import { showText } from "../run/text_sign";
import { spokenText } from "../run/values";
import { lazy } from "../shell/lazy";
import { program } from "../shell/session";
import { prefersStill, theme } from "../shell/theme";
import type { Bundle } from "./bundle/bundle";
import type { Companion } from "./companion";
import { startOf, toWorld, type XY } from "./frames";
import type { Framing } from "./framing/framed_viewport";
import type { Livery } from "./livery/livery";
import { markText } from "./mark_text";
import { savePicture } from "./picture";
import type { Measurements } from "./ranges_view";
import { SceneRenderer } from "./renderer";
import { CELEBRATION_MS } from "./signs/celebration_view";
import type { SolidView } from "./solid/view";
import { drawMeasure, measureText } from "./tools/measure_view";
import { PathLegend } from "./tools/PathLegend";
import { type Grip, listenToPointer } from "./tools/pointer_input";
import { SolidEnd } from "./tools/SolidEnd";
import { Toolbar } from "./tools/Toolbar";
import { SceneTools } from "./tools/tools";
import { CameraChoice } from "./tools/ViewChoice";
import { endSolid, isSolid } from "./tools/view_mode";

/** three.js is fetched when a floor is first shown in 3D. */
const SolidFloor = lazy(
  async () => (await import("./solid/SolidFloor")).SolidFloor,
  ({ floor }) => {
    useEffect(() => endSolid("not_fetched", floor), []);
    return null;
  },
);

/** Handling of a robot that the user can drag and whose sensors can be displayed. */
export interface RobotHold {
  readonly grip: ReadonlySignal<Grip>;
  readonly canReset: ReadonlySignal<boolean>;
  readonly ranges: ReadonlySignal<Measurements | null>;
  again(): void;
}

interface SceneProps {
  world: World | null;
  /** The robot on this floor; null until the robot models are loaded. */
  robot: Robot | null;
  /** What the group of the run chose for its robot; null without a group. */
  livery?: Livery | null;
  view: ReadonlySignal<RunView>;
  /** The robot's pose at a time of the screen's clock, interpolated between the ticks of `view`. */
  poseAt(now: number): Pose;
  /** The state whose whole path the viewport shows; by default the state of `view`. */
  whole?: ReadonlySignal<RunView>;
  /** A second run drawn on the same floor. */
  companion?: ReadonlySignal<Companion | null>;
  /** Paths of many robots on the same floor. */
  bundle?: ReadonlySignal<Bundle | null>;
  /** Called with the id of the path of the bundle that is clicked. */
  onPath?(id: number): void;
  /** Absent if a run is only displayed. */
  hold?: RobotHold;
  /** Whether a recorded run plays; absent if the run is live. */
  playing?: ReadonlySignal<boolean>;
  /** The run whose solved mission is celebrated as soon as it is set; absent if a run is only displayed. */
  solved?: ReadonlySignal<string | null>;
  /** How much larger than usual lines and texts are drawn, for a floor without tools. */
  magnification?: () => number;
}

/** The floor from above, or in 3D. Wheel and buttons zoom, dragging pans or moves the robot, tools measure. */
export function Scene(props: SceneProps) {
  const { world, robot, view, hold } = props;
  const tools = useInstance(() => new SceneTools());
  const [canvas, renderer] = useFlatFloor(props, tools);
  const solid = useSignal<SolidView | null>(null);
  const shown = () => solid.peek() ?? renderer.current;
  const isHidden = isSolid.value && solid.value !== null;
  return (
    <div class="scene">
      <Canvas {...{ canvas, world, view, tools, hold, isHidden }} ghost={props.companion} />
      {isSolid.value && (
        <SolidFloor
          {...props}
          ranges={hold?.ranges}
          floor={tools}
          onView={(now) => {
            solid.value = now;
          }}
        />
      )}
      <Toolbar
        scene={shown}
        tools={tools}
        again={hold ? { able: hold.canReset.value, act: () => hold.again() } : null}
        sensors={hold ? robot : null}
        onPicture={() => {
          const floor = shown();
          if (floor) void savePicture(floor, program.peek()?.name ?? "PINEL");
        }}
      />
      <CameraChoice />
      <PathLegend view={view} />
      <MeasureHint tools={tools} />
      <SolidEnd floor={tools} />
    </div>
  );
}

/** The canvas of the floor from above, and what draws on it. */
function useFlatFloor(
  {
    world,
    robot,
    livery = null,
    view,
    poseAt,
    whole,
    companion,
    bundle,
    onPath,
    hold,
    playing,
    solved,
    magnification,
  }: SceneProps,
  tools: SceneTools,
) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const renderer = useRef<SceneRenderer | null>(null);

  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const onFraming = (framing: Framing) => {
      tools.follow.value = framing === "robot";
    };
    const scene = new SceneRenderer(element, poseAt, prefersStill, onFraming, hold !== undefined);
    renderer.current = scene;
    const resize = () => scene.resize(element.clientWidth, element.clientHeight, magnification?.());
    const sizes = new ResizeObserver(resize);
    sizes.observe(element);
    const stops = [
      effect(() => scene.setView(view.value, whole?.value)),
      effect(() => {
        for (const one of [theme, language]) one.value;
        scene.setTheme();
      }),
      effect(() => scene.setMovable(hold?.grip.value.isAtStart ?? false)),
      effect(() => scene.setRanges(hold?.ranges.value ?? null)),
      effect(() => scene.setCompanion(companion?.value ?? null)),
      effect(() => scene.setBundle(bundle?.value ?? null)),
      showSigns(scene, view, playing),
      celebrate(scene, element, solved),
      showMeasure(scene, tools),
      listenToPointer({
        element,
        scene,
        tools,
        grip: () => hold?.grip.peek() ?? null,
        onClick: (place) => {
          const path = scene.pathAt(place);
          if (path) onPath?.(path.id);
        },
        snapPoints: () => placesOn(scene, view.peek()),
      }),
      putAwayOnEscape(tools),
    ];
    return () => {
      for (const stop of stops) stop();
      sizes.disconnect();
      scene.dispose();
    };
  }, [view, poseAt, whole, companion, bundle, hold, playing, solved]);

  const { colour, pattern, name } = livery ?? {};
  useEffect(() => renderer.current?.setWorld(world), [world]);
  useEffect(() => renderer.current?.setRobot(robot), [robot, view, poseAt, hold]);
  useEffect(() => renderer.current?.setLivery(livery), [colour, pattern, name, view, poseAt, hold]);

  return [canvas, renderer] as const;
}

interface CanvasProps {
  world: World | null;
  canvas: { current: HTMLCanvasElement | null };
  view: ReadonlySignal<RunView>;
  tools: SceneTools;
  hold: RobotHold | undefined;
  ghost: SceneProps["companion"];
  isHidden: boolean;
}

function Canvas({ canvas, world, view, tools, hold, ghost, isHidden }: CanvasProps) {
  const { truth, phase, output } = view.value;
  const { scene } = texts.value;
  const label = scene.label({
    x: metres(truth.x, language.value),
    y: metres(truth.y, language.value),
    heading: degrees(headingDegrees(truth.yaw), language.value),
  });
  const markLabels = output.marks.map((mark) => markText(mark, world, texts.value, language.value));
  const marks = markLabels.length > 0 ? scene.marks({ all: markLabels.join("; ") }) : "";
  const keys = tools.tool.value ? scene.measureKeys : hold ? scene.startKeys : "";
  return (
    <>
      {/* biome-ignore lint/a11y/noInteractiveElementToNoninteractiveRole: keys move the start and the tools */}
      <canvas
        ref={canvas}
        class="scene__canvas"
        hidden={isHidden}
        role="application"
        aria-label={[label, marks, keys].filter(Boolean).join(" ")}
        tabIndex={0}
        data-testid="scene"
        data-phase={phase}
        data-ghost={ghost?.value ? "true" : "false"}
        data-tool={tools.tool.value ?? ""}
      />
      {/* a screen reader announces the newest mark when the robot draws it */}
      <output class="visually-hidden" data-testid="last-mark">
        {markLabels.at(-1)}
      </output>
    </>
  );
}

/** Instructions for the active tool, then its measurement. */
function MeasureHint({ tools }: { tools: SceneTools }) {
  const { value: tool } = tools.tool;
  const { value: result } = tools.result;
  if (!tool) return null;
  const { scene } = texts.value;
  const text = result ? measureText(result, texts.value, language.value) : "";
  const value = result?.kind === "distance" ? result.metres : result?.degrees;
  return (
    <output
      class={text ? "visually-hidden" : "scene__hint"}
      data-testid="measure"
      data-value={value?.toFixed(3) ?? ""}
    >
      {text || scene[tool === "ruler" ? "rulerHint" : "protractorHint"]}
    </output>
  );
}

/** Shows beeps and texts at the robot. The dialogue below tells the same to screen readers. */
function showSigns(
  scene: SceneRenderer,
  view: SceneProps["view"],
  playing: SceneProps["playing"],
): () => void {
  const isStill = () => playing?.value === false;
  const bubbleText = (text: DialogueLine["text"] | null) =>
    text === null ? "" : spokenText(text, language.peek());
  const stops = [
    showBeeps(view, isStill, (n) => {
      const beep = n > 0 ? texts.peek().show.beeps({ count: n }) : "";
      scene.sign((signs) => signs.setBeep(beep));
    }),
    showText(view, isStill, (text) => scene.sign((signs) => signs.setText(bubbleText(text)))),
  ];
  return () => {
    for (const stop of stops) stop();
  };
}

/** Celebrates each mission that is solved while the floor is shown. */
function celebrate(
  scene: SceneRenderer,
  canvas: HTMLCanvasElement,
  solved: SceneProps["solved"],
): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let last = solved?.peek() ?? null;
  const end = () => {
    clearTimeout(timer);
    delete canvas.dataset.celebrating;
  };
  const stop = effect(() => {
    const run = solved?.value ?? null;
    if (run === last) return;
    last = run;
    end();
    if (run === null) return;
    scene.sign((signs) => signs.celebrate());
    canvas.dataset.celebrating = "true";
    timer = setTimeout(end, CELEBRATION_MS);
  });
  return () => {
    stop();
    end();
  };
}

function showMeasure(scene: SceneRenderer, tools: SceneTools): () => void {
  return effect(() => {
    const { value: tool } = tools.tool;
    const { value: points } = tools.shown;
    const { value: result } = tools.result;
    const text = result ? measureText(result, texts.value, language.value) : "";
    scene.setOverlay(
      tool &&
        ((ctx, viewport, size, colours) =>
          drawMeasure(ctx, tool, points, text, [viewport, size], colours)),
    );
  });
}

/** Points that the ruler snaps to: the robot, the start and all marks. */
function placesOn(scene: SceneRenderer, { output }: RunView): XY[] {
  const start = startOf(scene.shownWorld);
  const marks = output.marks.map((mark) => toWorld(start, mark.x, mark.y));
  return [scene.robotAt, start, ...marks];
}

function putAwayOnEscape(tools: SceneTools): () => void {
  return listen(window, {
    keydown: ({ key }) => key === "Escape" && tools.tool.peek() && tools.toggle(null),
  });
}
