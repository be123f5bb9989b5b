import type { ReadonlySignal } from "@preact/signals";
import { effect } from "@preact/signals";
import { Minus, Plus, Scan } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import type { World } from "../api/model";
import { TEST } from "../app/testids";
import { prefersStill, theme } from "../app/theme";
import { language, texts } from "../i18n";
import { degrees, headingDegrees, metres } from "../i18n/format";
import type { Pose, RunView } from "../run/reducer";
import { SceneRenderer } from "./renderer";
import "./scene.css";

const ZOOM_STEP = 1.4;

interface SceneProps {
  world: World | null;
  view: ReadonlySignal<RunView>;
  /** Where the robot is at a moment of the screen's clock, finer than the ticks of `view`. */
  poseAt(now: number): Pose;
}

/** The floor from above. Wheel and buttons zoom, dragging moves it, the frame button brings it back. */
export function Scene({ world, view, poseAt }: SceneProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const renderer = useRef<SceneRenderer | null>(null);

  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const scene = new SceneRenderer(element, poseAt, prefersStill);
    renderer.current = scene;
    const sizes = new ResizeObserver(() => scene.resize(element.clientWidth, element.clientHeight));
    sizes.observe(element);
    const stopView = effect(() => scene.setView(view.value));
    const stopTheme = effect(() => {
      theme.value;
      scene.setTheme();
    });
    const stopPointer = followPointer(element, scene);
    return () => {
      for (const stop of [stopView, stopTheme, stopPointer]) stop();
      sizes.disconnect();
      scene.dispose();
    };
  }, [view, poseAt]);

  useEffect(() => renderer.current?.setWorld(world), [world]);

  return (
    <div class="scene">
      <Canvas canvas={canvas} view={view} />
      <Buttons scene={() => renderer.current} />
    </div>
  );
}

function Canvas({
  canvas,
  view,
}: {
  canvas: { current: HTMLCanvasElement | null };
  view: ReadonlySignal<RunView>;
}) {
  const { pose, phase } = view.value;
  const label = texts.value.scene.label(
    metres(pose.x, language.value),
    metres(pose.y, language.value),
    degrees(headingDegrees(pose.yaw), language.value),
  );
  return (
    <canvas
      ref={canvas}
      class="scene__canvas"
      role="img"
      aria-label={label}
      data-testid={TEST.scene}
      data-phase={phase}
    />
  );
}

function Buttons({ scene }: { scene(): SceneRenderer | null }) {
  const words = texts.value.scene;
  const button = (label: string, Icon: typeof Plus, act: (now: SceneRenderer) => void) => (
    <button
      type="button"
      class="scene__button"
      aria-label={label}
      title={label}
      onClick={() => {
        const now = scene();
        if (now) act(now);
      }}
    >
      <Icon class="icon" aria-hidden="true" />
    </button>
  );
  return (
    <div class="scene__buttons">
      {button(words.zoomIn, Plus, (now) => now.zoom(ZOOM_STEP))}
      {button(words.zoomOut, Minus, (now) => now.zoom(1 / ZOOM_STEP))}
      {button(words.fit, Scan, (now) => now.frame())}
    </div>
  );
}

function followPointer(element: HTMLCanvasElement, scene: SceneRenderer): () => void {
  let last: { x: number; y: number } | null = null;
  const down = (event: PointerEvent) => {
    last = { x: event.clientX, y: event.clientY };
    element.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent) => {
    if (!last) return;
    scene.pan(event.clientX - last.x, event.clientY - last.y);
    last = { x: event.clientX, y: event.clientY };
  };
  const up = () => {
    last = null;
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    scene.zoom(Math.exp(-event.deltaY / 500));
  };
  element.addEventListener("pointerdown", down);
  element.addEventListener("pointermove", move);
  element.addEventListener("pointerup", up);
  element.addEventListener("pointercancel", up);
  element.addEventListener("wheel", wheel, { passive: false });
  return () => {
    element.removeEventListener("pointerdown", down);
    element.removeEventListener("pointermove", move);
    element.removeEventListener("pointerup", up);
    element.removeEventListener("pointercancel", up);
    element.removeEventListener("wheel", wheel);
  };
}
