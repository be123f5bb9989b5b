/** The product's logo: the robot seen from above at the corner of its path. */
export function Logo() {
  return (
    <svg class="mark" viewBox="0 0 40 40" aria-hidden="true">
      <rect width="40" height="40" rx="10" class="mark__ground" />
      <path d="M9 31V15a6 6 0 0 1 6-6h8" class="mark__path" />
      <g transform="translate(26 9.5)">
        <rect x="-6" y="-6.5" width="12" height="13" rx="4" class="mark__robot" />
        <path d="M3.6 0-1.8 3.4-.6 0l-1.2-3.4z" fill="#fff" />
      </g>
      <circle cx="9" cy="31" r="3" class="mark__start" />
    </svg>
  );
}
