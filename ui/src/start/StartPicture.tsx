/** Illustration: a robot that has driven a square. */
export function StartPicture() {
  const lines = Array.from({ length: 9 }, (_, index) => index * 60);
  return (
    <svg class="start-picture" viewBox="0 0 480 480" aria-hidden="true">
      <defs>
        <clipPath id="start-picture-floor">
          <rect width="480" height="480" rx="28" />
        </clipPath>
      </defs>
      <g clip-path="url(#start-picture-floor)">
        <rect width="480" height="480" class="start-picture__floor" />
        {lines.map((at) => (
          <path key={at} d={`M${at} 0V480M0 ${at}H480`} class="start-picture__line" />
        ))}
        <path d="M120 360H360V120H120V214" class="start-picture__path" />
        <path d="M120 226V326" class="start-picture__plan" />
        <circle cx="120" cy="360" r="14" class="start-picture__start" />
        <g transform="translate(120 196) rotate(90)">
          <rect x="-22" y="-64" width="54" height="22" rx="9" class="start-picture__wheel" />
          <rect x="-22" y="42" width="54" height="22" rx="9" class="start-picture__wheel" />
          <path
            d="M-62-30q0-20 22-20H30q44 8 44 50T30 50h-70q-22 0-22-20z"
            class="start-picture__robot"
          />
          <rect x="-46" y="-32" width="90" height="64" rx="18" class="start-picture__deck" />
          <path d="M36 0-6 24 4 0-6-24z" fill="#fff" />
          {[-62, -38, -13, 13, 38, 62].map((angle) => (
            <circle
              key={angle}
              cx={14 + 46 * Math.cos((angle * Math.PI) / 180)}
              cy={43 * Math.sin((angle * Math.PI) / 180)}
              r="3.6"
              fill="#e9b949"
            />
          ))}
        </g>
      </g>
    </svg>
  );
}
