import { texts } from "../../i18n";

interface FilesLeftProps {
  paths: readonly string[];
}

/** Files that still contain deleted data and must be deleted manually. */
export function FilesLeft({ paths }: FilesLeftProps) {
  if (paths.length === 0) return null;
  return (
    <>
      <p>{texts.value.exchange.deletion.left}</p>
      <ul>
        {paths.map((path) => (
          <li key={path}>{path}</li>
        ))}
      </ul>
    </>
  );
}
