document.getElementById("app")?.append("PINEL");
