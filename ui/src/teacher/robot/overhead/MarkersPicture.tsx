import { texts } from "../../../i18n";

/** Places of the sheets in the picture, by their numbers from 1: the corners of the rectangle, and the robot. */
const PLACES = [
  [28, 112],
  [172, 112],
  [172, 28],
  [28, 28],
  [108, 66],
] as const;
const SIDE = 26;

/** The sheets from above; during a trial those that the camera sees are filled. */
export function MarkersPicture({ seen = [] }: { seen?: readonly number[] }) {
  return (
    <svg class="markers" viewBox="0 0 200 140" role="img" aria-label={texts.value.overhead.picture}>
      <path class="markers__frame" d="M28 112H172V28H28Z" />
      <circle class="markers__robot" cx="108" cy="66" r="23" />
      <path class="markers__arrow" d="M108 34l-8 9h16z" />
      {PLACES.map(([x, y], index) => (
        <g key={`${x} ${y}`} class="markers__sheet" data-seen={seen.includes(index + 1)}>
          <rect x={x - SIDE / 2} y={y - SIDE / 2} width={SIDE} height={SIDE} rx="2" />
          <text x={x} y={y + 6}>
            {index + 1}
          </text>
        </g>
      ))}
    </svg>
  );
}
