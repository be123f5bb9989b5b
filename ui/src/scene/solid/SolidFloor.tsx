import { effect, type ReadonlySignal, useSignal } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Robot, World } from "../../api/model";
import { language, texts } from "../../i18n";
import { listen } from "../../kit/listen";
import { showBeeps } from "../../run/beep_sign";
import type { Pose, RunView } from "../../run/reducer";
import { prefersStill, theme } from "../../shell/theme";
import type { Bundle } from "../bundle/bundle";
import type { Companion } from "../companion";
import type { Livery } from "../livery/livery";
import type { Measurements } from "../ranges_view";
import { CAMERA_MODES, cameraMode, endSolid } from "../tools/view_mode";
import { describeFloor } from "./description";
import { qualityOf } from "./quality";
import { firstLevel } from "./surface";
import { SolidView } from "./view";

/** The quality that this PC reached; all floors begin with it. */
let level: number | null = null;

/** Minimum time between two descriptions of the picture, ms. */
const DESCRIBED_MS = 2000;

interface SolidFloorProps {
  world: World | null;
  robot: Robot | null;
  livery?: Livery | null | undefined;
  view: ReadonlySignal<RunView>;
  poseAt(now: number): Pose;
  whole?: ReadonlySignal<RunView> | undefined;
  companion?: ReadonlySignal<Companion | null> | undefined;
  /** Paths of many robots on the same floor. */
  bundle?: ReadonlySignal<Bundle | null> | undefined;
  playing?: ReadonlySignal<boolean> | undefined;
  ranges?: ReadonlySignal<Measurements | null> | undefined;
  magnification?: (() => number) | undefined;
  /** The floor to which a message belongs if 3D ends. */
  floor: object;
  /** Called with the view when its first frame is drawn, and with null at its end. */
  onView(view: SolidView | null): void;
}

/** The floor in 3D. Dragging turns the view, wheel and pinch zoom; the camera may follow the robot or be its eye. */
export function SolidFloor(props: SolidFloorProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const antialias = useSignal(qualityOf(levelNow()).antialias);
  const solid = useSolidView(canvas, props, antialias.value, (now) => {
    antialias.value = qualityOf(now).antialias;
  });
  const { world, robot, livery = null, view } = props;
  const { colour, pattern } = livery ?? {};
  useEffect(() => solid.current?.setLivery(livery), [colour, pattern, solid.current]);
  useEffect(() => solid.current?.setWorld(world), [world, solid.current]);
  useEffect(() => solid.current?.setRobot(robot), [robot, solid.current]);
  const label = useDescription(props);
  return (
    // biome-ignore lint/a11y/noInteractiveElementToNoninteractiveRole: keys turn the view
    <canvas
      key={String(antialias.value)}
      ref={canvas}
      class="scene__canvas"
      role="application"
      aria-label={`${label.value} ${texts.value.solid.keys}`}
      tabIndex={0}
      data-testid="scene-3d"
      data-phase={view.value.phase}
      data-camera={cameraMode.value}
    />
  );
}

function levelNow(): number {
  level ??= firstLevel();
  return level;
}

function useSolidView(
  canvas: RefObject<HTMLCanvasElement>,
  props: SolidFloorProps,
  antialias: boolean,
  onLevel: (level: number) => void,
): RefObject<SolidView> {
  const solid = useRef<SolidView | null>(null);
  const { view, poseAt, whole, companion, bundle, playing, ranges, floor, onView } = props;
  useEffect(() => {
    const element = canvas.current;
    const scene = element && openView(element, props, onLevel);
    if (!scene) {
      endSolid("no_webgl", floor);
      return;
    }
    solid.current = scene;
    scene.setLivery(props.livery ?? null);
    scene.setWorld(props.world);
    scene.setRobot(props.robot);
    const resize = () =>
      scene.resize(element.clientWidth, element.clientHeight, props.magnification?.());
    const sizes = new ResizeObserver(resize);
    sizes.observe(element);
    const stops = [
      effect(() => scene.setView(view.value, whole?.value)),
      effect(() => {
        for (const one of [theme, language]) one.value;
        scene.setTheme();
      }),
      effect(() => scene.setRanges(ranges?.value ?? null)),
      effect(() => scene.setCompanion(companion?.value ?? null)),
      effect(() => scene.setBundle(bundle?.value ?? null)),
      effect(() => scene.setCamera(cameraMode.value)),
      showBeeps(
        view,
        () => playing?.value === false,
        (n) => scene.setBeep(n > 0 ? texts.peek().show.beeps({ count: n }) : ""),
      ),
      listenToKeys(element, scene),
      listenToLoss(element, floor),
    ];
    return () => {
      for (const stop of stops) stop();
      sizes.disconnect();
      onView(null);
      solid.current = null;
      scene.dispose();
    };
  }, [view, poseAt, whole, companion, bundle, playing, ranges, antialias]);
  return solid;
}

function openView(
  canvas: HTMLCanvasElement,
  { poseAt, onView, floor }: SolidFloorProps,
  onLevel: (level: number) => void,
): SolidView | null {
  try {
    const scene: SolidView = new SolidView(canvas, {
      poseAt,
      still: prefersStill,
      level: levelNow(),
      onLevel: (now) => {
        level = now;
        onLevel(now);
      },
      onFirstFrame: () => onView(scene),
      onFailure: () => endSolid("no_webgl", floor),
    });
    return scene;
  } catch {
    return null; // no context, or one that three.js cannot use
  }
}

const TURNS: Readonly<Record<string, readonly [left: number, up: number]>> = {
  ArrowLeft: [1, 0],
  ArrowRight: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const ZOOMS: Readonly<Record<string, number>> = { "+": 1.2, "=": 1.2, "-": 1 / 1.2 };

/** Arrow keys turn the view, + and - zoom, 0 shows everything, 1 to 3 choose the camera. */
function listenToKeys(canvas: HTMLCanvasElement, scene: SolidView): () => void {
  const act = (key: string): boolean => {
    const [turn, zoom, mode] = [TURNS[key], ZOOMS[key], CAMERA_MODES[Number(key) - 1]];
    if (turn) scene.turn(...turn);
    else if (zoom) scene.zoom(zoom);
    else if (mode) cameraMode.value = mode;
    else if (key === "0") scene.frame();
    else return false;
    return true;
  };
  return listen(canvas, {
    keydown: (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !act(event.key)) return;
      event.preventDefault();
      event.stopPropagation();
    },
  });
}

/** A browser takes the context back when the graphics card fails or other pages need it. */
function listenToLoss(canvas: HTMLCanvasElement, floor: object): () => void {
  const lost = () => endSolid("lost", floor);
  canvas.addEventListener("webglcontextlost", lost);
  return () => canvas.removeEventListener("webglcontextlost", lost);
}

/** The picture in words, at most every two seconds, so that a screen reader can follow. */
function useDescription({ world, robot, view }: SolidFloorProps): ReadonlySignal<string> {
  const label = useSignal("");
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const describe = () => {
      const { truth, boxes } = view.peek();
      const shown = { world, boxes, truth, radius: robot?.radius_m ?? 0 };
      label.value = describeFloor(shown, texts.peek(), language.peek());
      timer = undefined;
    };
    const stop = effect(() => {
      for (const one of [view, texts]) one.value;
      timer ??= setTimeout(describe, label.peek() ? DESCRIBED_MS : 0);
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, [world, robot, view]);
  return label;
}
